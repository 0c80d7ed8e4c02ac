// A sound file holds every block that it was given, though many are written at once.
#include "rigsound/audio/file_sink.hpp"

#include <doctest/doctest.h>
#include <sndfile.h>

#include <string>
#include <vector>

#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::audio;
using namespace rigsound::test;

namespace {

constexpr int kSkippedAfter = 500, kSkipped = 300;

float sample_of(std::size_t i) { return static_cast<float>(i % 997) / 1024; }

/// `blocks` that count their samples, with silence in between; the bytes that the tap was shown.
std::string write(const std::filesystem::path& file, const FileSink::Format& format, int blocks) {
  std::string shown;
  FileSink sink(file, format, [&shown](const void* bytes, std::size_t size) {
    shown.append(static_cast<const char*>(bytes), size);
  });
  std::vector<float> block(static_cast<std::size_t>(format.block * format.channels));
  for (int number = 0; number < blocks; ++number) {
    if (number == kSkippedAfter) sink.skip(kSkipped);
    for (std::size_t i = 0; i < block.size(); ++i)
      block[i] = sample_of(static_cast<std::size_t>(number) * block.size() + i);
    sink.write(block.data(), static_cast<std::uint64_t>(number));
  }
  sink.commit();
  return shown;
}

std::vector<float> read(const std::filesystem::path& file) {
  SF_INFO info{};
  SNDFILE* const sound = sf_open(file.c_str(), SFM_READ, &info);
  REQUIRE(sound != nullptr);
  std::vector<float> samples(static_cast<std::size_t>(info.frames * info.channels));
  sf_read_float(sound, samples.data(), static_cast<sf_count_t>(samples.size()));
  sf_close(sound);
  return samples;
}

}  // namespace

TEST_CASE("A file holds every block in order, and silence where blocks were skipped") {
  const TemporaryFolder folder;
  // More and less than what is written at once, and blocks that do not divide it.
  for (const int frames : {32, 96, 2048})
    for (const int blocks : {1, kSkippedAfter, 1203}) {
      CAPTURE(frames);
      CAPTURE(blocks);
      FileSink::Format format;
      format.block = frames;
      const std::string shown = write(folder.path / "a.wav", format, blocks);
      const std::vector<float> samples = read(folder.path / "a.wav");
      const std::size_t a_block = static_cast<std::size_t>(frames) * 2;
      const bool skipped = blocks > kSkippedAfter;
      REQUIRE(samples.size() == a_block * static_cast<std::size_t>(blocks + (skipped ? kSkipped : 0)));
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t from = a_block * kSkippedAfter, to = from + a_block * kSkipped;
        const float expected = i < from || !skipped ? sample_of(i)
                               : i < to             ? 0.0F
                                                    : sample_of(i - a_block * kSkipped);
        wrong += samples[i] != expected ? 1 : 0;
      }
      CHECK(wrong == 0);
      CHECK(content(folder.path / "a.wav").substr(content(folder.path / "a.wav").size() - shown.size()) ==
            shown);
      CHECK(shown.size() == samples.size() * sizeof(float));
    }
}
