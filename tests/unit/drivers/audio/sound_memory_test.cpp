// A file in memory behaves as one on disk.
#include "rigsound/audio/sound_memory.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <string>
#include <vector>

using namespace rigsound::audio;

namespace {

struct OpenMemory {
  std::string read(sf_count_t count) {
    std::string text(static_cast<std::size_t>(count), '?');
    const sf_count_t got = io.read(text.data(), count, &memory);
    return text.substr(0, static_cast<std::size_t>(got));
  }
  sf_count_t write(const std::string& text) {
    return io.write(text.data(), static_cast<sf_count_t>(text.size()), &memory);
  }
  sf_count_t seek(sf_count_t offset, int whence) { return io.seek(offset, whence, &memory); }
  sf_count_t tell() { return io.tell(&memory); }

  SoundMemory memory;
  SF_VIRTUAL_IO io = sound_memory_io();
};

}  // namespace

TEST_CASE("What is written in pieces stands in turn, and over what was there") {
  OpenMemory m;
  CHECK(m.write("abc") == 3);
  CHECK(m.write("def") == 3);
  CHECK(m.tell() == 6);
  CHECK(m.memory.bytes == "abcdef");
  CHECK(m.seek(1, SEEK_SET) == 1);
  CHECK(m.write("XY") == 2);
  CHECK(m.memory.bytes == "aXYdef");
  CHECK(m.tell() == 3);
  CHECK(m.seek(-1, SEEK_END) == 5);
  CHECK(m.write("123") == 3);
  CHECK(m.memory.bytes == "aXYde123");
  CHECK(m.seek(2, SEEK_END) == 10);
  CHECK(m.write("z") == 1);
  CHECK(m.memory.bytes == std::string("aXYde123\0\0z", 11));
  CHECK(m.io.get_filelen(&m.memory) == 11);
}

TEST_CASE("Reading goes on where it stopped, and stops at the end") {
  OpenMemory m;
  m.memory.bytes = "abcdef";
  CHECK(m.read(2) == "ab");
  CHECK(m.read(3) == "cde");
  CHECK(m.tell() == 5);
  CHECK(m.read(3) == "f");
  CHECK(m.read(3).empty());
  CHECK(m.tell() == 6);
  CHECK(m.seek(-4, SEEK_CUR) == 2);
  CHECK(m.read(1) == "c");
  CHECK(m.seek(-9, SEEK_CUR) == 0);
  CHECK(m.seek(9, SEEK_SET) == 9);
  CHECK(m.read(1).empty());
}

TEST_CASE("libsndfile writes a sound there and reads it back") {
  SoundMemory memory;
  SF_VIRTUAL_IO io = sound_memory_io();
  SF_INFO info{};
  info.samplerate = 48000, info.channels = 1, info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  std::vector<float> sound(10000);
  for (std::size_t i = 0; i < sound.size(); ++i) sound[i] = static_cast<float>(i) / 16384;
  SNDFILE* const out = sf_open_virtual(&io, SFM_WRITE, &info, &memory);
  REQUIRE(out != nullptr);
  for (std::size_t at = 0; at < sound.size(); at += 2500)
    CHECK(sf_write_float(out, &sound[at], 2500) == 2500);
  sf_close(out);
  memory.at = 0;
  SF_INFO found{};
  SNDFILE* const in = sf_open_virtual(&io, SFM_READ, &found, &memory);
  REQUIRE(in != nullptr);
  std::vector<float> again(sound.size());
  CHECK(sf_read_float(in, again.data(), 10000) == 10000);
  sf_close(in);
  CHECK(again == sound);
}
