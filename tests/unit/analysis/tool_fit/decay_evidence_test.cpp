// Blows of known decay at several lengths and levels of noise: does the recording tell it, and is it right?
#include "tool_fit/decay_evidence.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/random.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/tool_design.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

struct Blow {
  double t60_s = 0.3, length_s = 0.3, noise_db = -50;  ///< noise over the blow's peak
  double before_s = 0.2;                               ///< noise alone
  Bar bar{0.5, 0.025};
};

/// All modes of the bar with one decay, amplitudes and phases drawn; noise over all of it.
RecordedImpact recorded(const Blow& blow, std::uint64_t seed) {
  const dsp::RandomField random(seed, 7);
  const auto length = static_cast<std::size_t>(blow.length_s * kAnalysisRate);
  std::vector<double> sound(length, 0.0);
  std::uint64_t draw = 0;
  for (const double hz : modes_below(blow.bar, 18000)) {
    const double amplitude = std::exp(0.5 * random.normal(draw, 1)), phase = 6.283 * random.uniform(draw, 6);
    ++draw;
    const std::complex<double> step =
        std::polar(std::pow(10, -3 / (blow.t60_s * kAnalysisRate)), 2 * M_PI * hz / kAnalysisRate);
    std::complex<double> z = std::polar(amplitude, phase);
    for (double& x : sound) x += z.real(), z *= step;
  }
  double peak = 0;
  for (const double x : sound) peak = std::max(peak, std::fabs(x));
  const double noise = std::pow(10, blow.noise_db / 20);
  const auto at = [&](std::uint64_t n) { return noise * random.normal(n, 3); };
  RecordedImpact impact;
  const auto before = static_cast<std::size_t>(blow.before_s * kAnalysisRate);
  for (std::size_t n = 0; n < before; ++n) impact.before.push_back(at(n));
  impact.onset = before;
  impact.sound.assign(kBeforeImpact, 0.0);
  for (std::size_t n = 0; n < length; ++n) impact.sound.push_back(sound[n] / peak + at(before + n));
  return impact;
}

struct Tally {
  int bands = 0, told = 0, at_least = 0, right = 0;
  double widest = 0;
};

/// Over every third octave that holds a mode of the bar, of `seeds` blows.
Tally tally(const Blow& blow, int seeds) {
  Tally sum;
  const std::vector<double> modes = modes_below(blow.bar, 18000);
  for (int seed = 0; seed < seeds; ++seed) {
    DecayEvidence evidence(recorded(blow, 100 + static_cast<std::uint64_t>(seed)));
    for (double centre = 125; centre < 16000; centre *= std::pow(2, 1.0 / 3)) {
      const bool rings = std::any_of(modes.begin(), modes.end(), [centre](double hz) {
        return std::fabs(std::log2(hz / centre)) < 1.0 / 6;
      });
      if (!rings) continue;
      const DecayBounds decay = evidence.band(centre).decay;
      ++sum.bands;
      sum.told += decay.told(), sum.at_least += !decay.told() && decay.low_s > 0;
      sum.right += decay.low_s <= blow.t60_s && blow.t60_s <= decay.high_s;
      if (decay.told()) sum.widest = std::max(sum.widest, decay.high_s / decay.low_s);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("the true decay lies within the 95 % bounds at every length and level of noise" *
          doctest::test_suite("long")) {
  Tally all;
  for (const double t60_s : {0.08, 0.3, 1.2})
    for (const double length_s : {0.04, 0.162, 0.5})
      for (const double noise_db : {-25.0, -45.0, -65.0}) {
        const Tally some = tally({t60_s, length_s, noise_db}, 6);
        CAPTURE(t60_s);
        CAPTURE(length_s);
        CAPTURE(noise_db);
        CHECK(some.right >= 0.95 * some.bands);  // 54 of them
        CHECK(some.widest <= 4);
        all.bands += some.bands, all.right += some.right;
      }
  CHECK(all.right >= 0.97 * all.bands);
}

TEST_CASE("a decay is told when the recording hears it fall, and has a lower bound when not") {
  const Tally heard = tally({0.3, 0.3, -65}, 4);
  CHECK(heard.told == heard.bands);
  CHECK(heard.widest < 2);
  const Tally cut_off = tally({7.5, 0.162, -65}, 4);  // falls by 1.3 dB
  CHECK(cut_off.told == 0);
  CHECK(cut_off.at_least >= 0.7 * cut_off.bands);
  const Tally drowned = tally({1.2, 0.5, 15}, 4);
  CHECK(drowned.told == 0);
}

TEST_CASE("the level of a band is the impact's where it stands out of the noise") {
  DecayEvidence quiet(recorded({0.3, 0.5, -60}, 1)), loud(recorded({0.3, 0.5, 10}, 1));
  CHECK(quiet.band(4000).share.low > 0.95);
  CHECK(quiet.band(4000).share.told());
  CHECK_FALSE(loud.band(16000).share.told());
}

TEST_CASE("a recording that tells too few decays is refused, and says what it is short of" *
          doctest::test_suite("long")) {
  const auto recording = [](const Blow& blow) {
    Recording r;
    r.source_rate = static_cast<int>(kAnalysisRate);
    const RecordedImpact impact = recorded(blow, 3);
    r.mono.assign(impact.before.begin(), impact.before.end());
    r.mono.insert(r.mono.end(), impact.sound.begin() + kBeforeImpact, impact.sound.end());
    return r;
  };
  const ToolFitOptions steel{0.5, 0.025};
  CHECK_THROWS_WITH_AS(
      fit_tool(recording({7.5, 0.162, -60}), "blow.wav", steel),
      doctest::Contains("blow.wav: tells the decay of 0 third octaves: the impact is heard for 16"),
      InputError);
  CHECK_THROWS_AS(fit_tool(recording({0.3, 0.3, -8}), "blow.wav", steel), InputError);
  const ToolFit fit = fit_tool(recording({0.2, 0.3, -60}), "blow.wav", steel);
  for (const TunedMode& mode : tuned_modes(fit.model, design_tool(fit.model, kAnalysisRate))) {
    const FittedBand* band = fit.band_at(mode.model_hz);
    if (band == nullptr) continue;
    CAPTURE(mode.model_hz);
    CHECK(band->decay.low_s <= 0.2);
    CHECK(band->decay.high_s >= 0.2);
    CHECK(mode.t60_s < 1.1 * band->decay.high_s);
    CHECK(band->recorded_low_db <= band->recorded_db);
    CHECK(band->recorded_high_db - band->recorded_low_db < 3);
  }
}
