// WAV files as recorders leave them that lost power, streamed, or count an odd chunk without its pad byte.
#include <doctest/doctest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "rigsound/analysis/recording.hpp"
#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

constexpr int kFrames = 24000;

std::string word(unsigned value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xff);
  return text;
}

std::string chunk(const std::string& name, const std::string& content, unsigned size) {
  return name + word(size, 4) + content;
}

std::string format() {
  return chunk("fmt ", word(1, 2) + word(1, 2) + word(48000, 4) + word(96000, 4) + word(2, 2) + word(16, 2),
               16);
}

/// A staircase: every sample tells where it stands.
std::string samples() {
  std::string pcm;
  for (int n = 0; n < kFrames; ++n) pcm += word(static_cast<unsigned>(n), 2);
  return pcm;
}

std::string data(unsigned size = 2 * kFrames) { return chunk("data", samples(), size); }

struct Read {
  std::string fault;
  bool whole;
};

Read read(const std::string& chunks) {
  const test::TemporaryFolder folder;
  const std::string body = "WAVE" + chunks;
  std::ofstream(folder.path / "a.wav", std::ios::binary)
      << "RIFF" << word(static_cast<unsigned>(body.size()), 4) << body;
  const Recording recording = read_recording(folder.path / "a.wav");
  bool whole = recording.source_frames == kFrames && recording.mono.size() == kFrames;
  for (std::size_t n = 0; whole && n < kFrames; n += 311)
    whole = recording.mono[n] == static_cast<float>(n) / 32768.0f;
  const std::vector<std::string> notes = reading_notes("a.wav", recording);
  CHECK(notes.size() == (recording.fault.empty() ? 0u : 1u));
  CHECK(recording_seconds(folder.path / "a.wav") == doctest::Approx(0.5));
  return {recording.fault, whole};
}

}  // namespace

TEST_CASE("samples that the header does not count are read to the end of the file, and that is said") {
  for (const std::string& before : {std::string(), chunk("bext", std::string(602, '\0'), 602)}) {
    const Read streamed = read(format() + before + data(0));
    CHECK(streamed.whole);
    CHECK(streamed.fault == "its header says that it holds no samples, read to its end");
  }
}

TEST_CASE("a chunk of odd length may lack its pad byte, before the format or behind it, and that is said") {
  for (const std::string& chunks :
       {format() + chunk("LIST", "INFOabc", 7) + data(), chunk("LIST", "INFOabc", 7) + format() + data()}) {
    const Read unpadded = read(chunks);
    CHECK(unpadded.whole);
    CHECK(unpadded.fault == "its 'LIST' chunk of odd length lacks the pad byte, read without it");
  }
}

TEST_CASE("what follows the samples is not read as one, and a sound file needs no repair") {
  for (const std::string& chunks :
       {format() + data(), format() + chunk("LIST", std::string("INFOabc\0", 8), 7) + data(),
        format() + data() + chunk("LIST", "INFOabc", 7), format() + data(0xffffffff)}) {
    const Read sound = read(chunks);
    CHECK(sound.whole);
    CHECK(sound.fault.empty());
  }
  const Read both = read(format() + chunk("LIST", "INFOabc", 7) + data() + chunk("LIST", "INFOabcd", 8));
  CHECK(both.whole);
}
