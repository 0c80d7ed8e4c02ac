// Recordings of any length: a piece at a time is in memory, and nothing else is different.
#include <doctest/doctest.h>
#include <samplerate.h>

#include <cmath>

#include "analysis/noise.hpp"
#include "recording/clipping.hpp"
#include "recording/resample.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "simulate/split_mix.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

std::vector<float> noise(std::size_t count, std::uint64_t seed) {
  SplitMix draw(seed);
  const std::vector<double> normal = draw.normals(static_cast<int>(count));
  std::vector<float> x;
  for (const double v : normal) x.push_back(static_cast<float>(0.1 * v));
  return x;
}

/// In pieces of 1, 2, 3, ... samples.
template <class Taker>
void in_pieces(const std::vector<float>& x, Taker take) {
  for (std::size_t at = 0, length = 1; at < x.size(); at += length, ++length) {
    const std::size_t end = std::min(x.size(), at + length);
    take({x.begin() + static_cast<long>(at), x.begin() + static_cast<long>(end)});
    length = end - at;
  }
}

}  // namespace

TEST_CASE("sound in a file is that in memory, in any piece, and outlives who made it") {
  const std::vector<float> x = noise(5000, 1), y = noise(700, 2);
  Samples kept, other;
  {
    SampleFile file;
    in_pieces(x, [&](const std::vector<float>& piece) { file.add(piece, kept); });
    other = file.keep(y);
  }
  CHECK(kept.size() == 5000);
  CHECK(kept.all() == x);
  CHECK(other.all() == y);
  for (const Samples& samples : {kept, Samples(x)})
    CHECK(samples.piece(1234, 2345) == std::vector<float>(x.begin() + 1234, x.begin() + 2345));
  CHECK(Samples().all().empty());
}

TEST_CASE("a rate is changed in pieces as libsamplerate changes it at once") {
  for (const int rate : {16000, 22050, 44100, 96000}) {
    CAPTURE(rate);
    const std::vector<float> x = noise(static_cast<std::size_t>(rate) / 2 + 7, 3);
    std::vector<float> whole(resampled_length(x.size(), rate, 48000)), pieces;
    SRC_DATA job{};
    job.data_in = x.data(), job.data_out = whole.data();
    job.input_frames = static_cast<long>(x.size()), job.output_frames = static_cast<long>(whole.size());
    job.src_ratio = 48000.0 / rate;
    REQUIRE(src_simple(&job, SRC_SINC_BEST_QUALITY, 1) == 0);
    Resampler resampler(rate, 48000, x.size());
    const auto add = [&](const std::vector<float>& y) { pieces.insert(pieces.end(), y.begin(), y.end()); };
    in_pieces(x, [&](const std::vector<float>& piece) { add(resampler.process(piece)); });
    add(resampler.finish());
    REQUIRE(pieces.size() == whole.size());
    double worst = 0;
    for (std::size_t n = 0; n < whole.size(); ++n)
      worst = std::max(worst, static_cast<double>(std::fabs(pieces[n] - whole[n])));
    CHECK(worst < 1e-6);
  }
}

TEST_CASE("flat tops are counted over the seams of pieces") {
  const std::vector<float> x = {0, 1, 1, 1, 0, -1, 0, -1, -1, 0.5, 1};  // tops of 3, 1, 2 and 1
  for (const std::size_t piece : {1, 2, 3, 11}) {
    FlatTops tops(1);
    for (std::size_t at = 0; at < x.size(); at += piece)
      tops.add(
          {x.begin() + static_cast<long>(at), x.begin() + static_cast<long>(std::min(x.size(), at + piece))});
    CHECK(tops.share() == doctest::Approx(5.0 / 11));
  }
  CHECK(FlatTops(0).share() == 0);
}

TEST_CASE("a long recording is read as a short one is") {
  const test::TemporaryFolder folder;
  const std::vector<float> x = noise(30000, 5);
  for (const int rate : {44100, 48000}) {
    write_wave(folder.path / "a.wav", x, rate);
    SampleFile file;
    const LongRecording kept = read_long_recording(folder.path / "a.wav", {0.1, 0.5}, file);
    const Recording whole = read_recording(folder.path / "a.wav", Stretch{0.1, 0.5});
    CHECK(kept.mono.all() == whole.mono);
    CHECK(kept.source_frames == whole.source_frames);
    CHECK(kept.clipped == whole.clipped);
    double length_s = 0;
    const auto second_half = [&](double recording_s) {
      length_s = recording_s;
      return Stretch{recording_s / 2};
    };
    CHECK(read_recording(folder.path / "a.wav", second_half, "sound").source_frames == 15000);
    CHECK(length_s == doctest::Approx(30000.0 / rate));
  }
}
