#include "rigsound/analysis/recording.hpp"

#include <doctest/doctest.h>
#include <sndfile.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "analysis/noise.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;
using namespace rigsound::analysis;
namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = fs::temp_directory_path() / "rigsound_recording_test";
  Folder() { fs::remove_all(path), fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

fs::path write(const fs::path& path, const std::vector<float>& frames, int rate, int channels) {
  SF_INFO info{};
  info.samplerate = rate;
  info.channels = channels;
  info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  SNDFILE* sound = sf_open(path.c_str(), SFM_WRITE, &info);
  REQUIRE(sound);
  sf_write_float(sound, frames.data(), sf_count_t(frames.size()));
  sf_close(sound);
  return path;
}

std::vector<float> tone(int count, double hz, int rate) {
  std::vector<float> x(size_t(count), 0.0f);
  for (int n = 0; n < count; ++n) x[n] = float(0.5 * std::sin(2 * kPi * hz * n / rate));
  return x;
}

std::string refusal(const fs::path& path) {
  try {
    read_recording(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

bool says(const std::string& text, const std::string& word) { return text.find(word) != std::string::npos; }

}  // namespace

TEST_CASE("what cannot be analysed is refused with the file's name and what was expected") {
  const Folder folder;
  const std::vector<float> good = tone(48000, 440, 48000);
  const auto expect = [&](const fs::path& path, const std::string& word) {
    const std::string text = refusal(path);
    CHECK_MESSAGE(
        (says(text, path.string()) && says(text, word) && says(text, "expected") && !says(text, "\n")), text);
  };
  expect(folder.path / "absent.wav", "no such file");
  expect(folder.path, "is a folder");
  std::ofstream(folder.path / "text.wav") << "not a sound";
  expect(folder.path / "text.wav", "not a sound file");
  expect(write(folder.path / "empty.wav", {}, 48000, 1), "no samples");
  expect(write(folder.path / "short.wav", tone(4800, 440, 48000), 48000, 1), "0.100 s");
  expect(write(folder.path / "silent.wav", std::vector<float>(48000, 0.0f), 48000, 1), "no drilling found");
  expect(write(folder.path / "slow.wav", tone(16000, 440, 8000), 8000, 1), "8000 Hz");
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    std::vector<float> x = good;
    x[24000] = bad;
    expect(write(folder.path / "bad.wav", x, 48000, 1), "sample 24000");
  }
}

TEST_CASE("flat tops are counted at the file's own rate, and a pure tone has none to speak of") {
  const Folder folder;
  std::vector<float> x = tone(44100, 97, 44100);
  CHECK(read_recording(write(folder.path / "whole.wav", x, 44100, 1)).clipped < 0.01);
  const float level = 0.4f;  // reached at 53.1 of 90 degrees
  for (float& v : x) v = std::min(std::max(v, -level), level);
  const double share = read_recording(write(folder.path / "cut.wav", x, 44100, 1)).clipped;
  CHECK(share == doctest::Approx(1 - std::asin(0.8) / (kPi / 2)).epsilon(0.02));
}

TEST_CASE("silence is read where it is no error, with an offset too") {
  const Folder folder;
  for (const float offset : {0.0f, 0.25f}) {
    const fs::path file = write(folder.path / "silent.wav", std::vector<float>(44100, offset), 44100, 1);
    CHECK_THROWS_AS(read_recording(file), InputError);
    const Recording recording = read_recording_or_silence(file);
    CHECK(recording.silent);
    CHECK(recording.source_frames == 44100);
  }
  CHECK_FALSE(
      read_recording_or_silence(write(folder.path / "tone.wav", tone(48000, 440, 48000), 48000, 1)).silent);
}

TEST_CASE("channels are averaged, however many, and said") {
  const Folder folder;
  std::vector<float> six;
  for (const float x : tone(48000, 300, 48000))
    for (int c = 0; c < 6; ++c) six.push_back(static_cast<float>(c) * 0.2f * x);
  const fs::path file = write(folder.path / "six.wav", six, 48000, 6);
  const Recording surround = read_recording(file);
  CHECK(surround.source_channels == 6);
  CHECK(reading_notes(file, surround) ==
        std::vector<std::string>{file.string() + ": 6 channels mixed down to one"});
  for (size_t n = 0; n < 48000; n += 977) CHECK(surround.mono[n] == doctest::Approx(0.5 * six[6 * n + 5]));
  std::vector<float> frames;
  for (const float x : tone(48000, 300, 48000)) frames.push_back(x), frames.push_back(0.5f * x);
  const Recording recording = read_recording(write(folder.path / "stereo.wav", frames, 48000, 2));
  CHECK(recording.source_channels == 2);
  CHECK(reading_notes("a.wav",
                      read_recording(write(folder.path / "mono.wav", tone(48000, 300, 48000), 48000, 1)))
            .empty());
  REQUIRE(recording.mono.size() == 48000);
  for (size_t n = 0; n < 48000; n += 977) CHECK(recording.mono[n] == doctest::Approx(0.75 * frames[2 * n]));
}

TEST_CASE("any rate becomes 48 kHz without moving in time, and goes back") {
  const Folder folder;
  for (const int rate : {16000, 22050, 44100, 96000}) {
    const std::vector<float> x = tone(rate, 1000, rate);
    const Recording recording = read_recording(write(folder.path / "rate.wav", x, rate, 1));
    REQUIRE(recording.mono.size() == 48000);
    double error = 0;
    for (int n = 4800; n < 43200; ++n)
      error = std::max(error, std::fabs(recording.mono[n] - 0.5 * std::sin(2 * kPi * n / 48.0)));
    CHECK(error < 2e-3);
    const std::vector<float> back = at_source_rate(recording, recording.mono);
    REQUIRE(back.size() == x.size());
    for (size_t n = x.size() / 4; n < x.size() / 2; n += 101)
      CHECK(back[n] == doctest::Approx(x[n]).epsilon(0.01).scale(1));
  }
}
