// The spectrum of endless synthesis against what is played, and against lines whose powers are known.
#include "bank/endless_spectrum.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rigsound/analysis/resynth.hpp"
#include "rigsound/dsp/energy.hpp"
#include "simulate/split_mix.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

/// Unit bursts of noise, each with a colour of its own, on a common thump.
ClickBank bursts(double mean_gap_samples) {
  ClickBank bank;
  bank.mean_gap_samples = mean_gap_samples;
  bank.mean_amplitude = 0.3;
  SplitMix stream(9);
  for (int c = 0; c < 6; ++c) {
    std::vector<float> click(3000);
    double low = 0;
    for (std::size_t n = 0; n < click.size(); ++n) {
      const double t = static_cast<double>(n);
      low += 0.15 * (c + 1) * (stream.normal() - low);
      click[n] = static_cast<float>(std::exp(-0.004 * t) * (low + std::sin(0.012 * t)));
    }
    dsp::divide(click.data(), click.size(), std::sqrt(dsp::energy(click)));
    bank.clicks.emplace_back(std::move(click));
  }
  return bank;
}

ClickBank uneven_bursts() {
  ClickBank bank = bursts(900);
  bank.gap_deviation_samples = 60, bank.gap_correlation = -0.3;
  bank.miss_share = 0.05, bank.double_share = 0.03;
  bank.amplitude_deviation = 0.1, bank.amplitude_correlation = 0.4;
  return bank;
}

/// Impulses of alternating sign: of two clicks none comes twice in a row.
ClickBank alternating(double gap_samples) {
  ClickBank bank;
  bank.mean_gap_samples = gap_samples;
  bank.mean_amplitude = 0.5;
  bank.clicks = {{1.0F}, {-1.0F}};
  return bank;
}

}  // namespace

TEST_CASE("played clicks are those that a resynthesis sounds of") {
  const ClickBank bank = uneven_bursts();
  const Resynthesis whole = resynthesise(bank, 3, 21);
  const std::vector<float>& sound = whole.sound;
  std::vector<double> sum(sound.size(), 0.0);
  for (const PlayedClick& played : played_clicks(bank, whole.impacts.size(), 21)) {
    const Click& click = bank.clicks[played.click];
    const auto onset = static_cast<std::size_t>(std::floor(played.time + 0.5));
    for (std::size_t n = 0; n < click.size() && onset + n < sum.size(); ++n)
      sum[onset + n] += bank.mean_amplitude * played.amplitude * static_cast<double>(click[n]);
  }
  double furthest = 0;
  for (std::size_t n = 0; n < sum.size(); ++n)
    furthest = std::max(furthest, std::fabs(sum[n] - static_cast<double>(sound[n])));
  CHECK(furthest < 1e-6);
}

TEST_CASE("impulses of alternating sign sound at the odd multiples of half their rate") {
  const double T = 240;  // 200 Hz
  const ClickBank bank = alternating(T);
  const EndlessSpectrum spectrum(ImpactPairs(bank), bank);
  CHECK(spectrum.mean_square() * T / 0.25 == doctest::Approx(1).epsilon(1e-3));
  const std::vector<double> level_db = spectrum.third_octaves().level_db;
  const double line_db = 10 * std::log10(2 * 0.25 / (T * T));
  for (const std::size_t odd : {2, 7, 9})  // the bands of 100, 300 and 500 Hz
    CHECK(std::fabs(level_db[odd] - line_db) < 0.05);
  for (const std::size_t even : {5, 8}) CHECK(level_db[even] < line_db - 30);  // 200 and 400 Hz
}

TEST_CASE("the spectrum of endless synthesis is that of a long one") {
  for (const ClickBank& bank : {uneven_bursts(), bursts(1700)}) {
    const EndlessSpectrum spectrum(ImpactPairs(bank), bank);
    const std::vector<float> sound = resynthesise(bank, 240, 3).sound;
    const BandLevels expected = spectrum.third_octaves(), played = third_octave_levels(sound);
    for (std::size_t band = 0; band < played.level_db.size(); ++band)
      CHECK(std::fabs(expected.level_db[band] - played.level_db[band]) < 0.15);
    const double mean_square = dsp::energy(sound) / static_cast<double>(sound.size());
    CHECK(spectrum.mean_square() / mean_square == doctest::Approx(1).epsilon(0.01));
  }
}
