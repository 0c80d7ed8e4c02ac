// The last step before the card: no sample passes the ceiling, on whichever channel.
#include "mix/output.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rigsound;
using namespace rigsound::mix;

namespace {

/// A chunk of 0.1 on both channels but for one sample.
std::vector<dsp::Lanes> quiet_but_one(double value, int at, int channel) {
  std::vector<dsp::Lanes> x(kChunk, dsp::Lanes{0.1, 0.1});
  x[static_cast<std::size_t>(at)][channel] = value;
  return x;
}

}  // namespace

TEST_CASE("a sample that rounding brings over the ceiling is set to it, its neighbours are left") {
  for (const double ceiling : {0.7, 0.89125})
    for (const int channels : {1, 2, 4})
      for (const int channel : {0, 1})
        for (const double sign : {1.0, -1.0})
          for (const int at : {0, 7, kChunk - 1}) {
            if (channels == 1 && channel == 1) continue;
            Output output(ceiling, channels);
            const float most = static_cast<float>(ceiling);
            const double over = std::nextafter(most, 2.0F);
            std::vector<float> out(static_cast<std::size_t>(kChunk * channels), 9);
            output.write(quiet_but_one(sign * over, at, channel).data(), GainCurve{}, out.data());
            CHECK(out[static_cast<std::size_t>(at * channels + channel)] == static_cast<float>(sign) * most);
            CHECK(std::count(out.begin(), out.end(), 0.1F) == kChunk * std::min(channels, 2) - 1);
            CHECK(output.take(kChunk).peak == most);
          }
}

TEST_CASE("a gain curve is applied sample by sample, and what was played is told once") {
  Output output(0.9, 2);
  const GainCurve gain = GainCurve::through(1, 0.5, 0.25);
  std::vector<float> out(2 * kChunk);
  output.write(std::vector<dsp::Lanes>(kChunk, dsp::Lanes{0.25, -0.5}).data(), gain, out.data());
  double energy = 0, peak = 0;
  for (int n = 0; n < kChunk; ++n) {
    const double g = gain.at(n);
    CHECK(out[static_cast<std::size_t>(2 * n)] == doctest::Approx(0.25 * g));
    CHECK(out[static_cast<std::size_t>(2 * n + 1)] == doctest::Approx(-0.5 * g));
    energy += (0.0625 + 0.25) * g * g, peak = std::max(peak, 0.5 * g);
  }
  const LayerLevel level = output.take(kChunk);
  CHECK(level.peak == doctest::Approx(peak));
  CHECK(level.rms == doctest::Approx(std::sqrt(energy / kChunk)));
  CHECK(output.take(kChunk).peak == 0);
}
