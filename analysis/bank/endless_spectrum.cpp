#include "bank/endless_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rigsound/analysis/resynth.hpp"
#include "spectrum/frame_pair.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kImpacts = 4096;
constexpr std::uint64_t kImpactSeed = 1;
constexpr int kPoints = 2 * kThirdOctaveFrame;  // of the spectrum: no frame hears a longer lag
constexpr int kSpectrumBins = kPoints / 2 + 1;

/// Adds the samples to `sum`; what is longer wraps around, which leaves the spectrum's values as they are.
void add_wrapped(const Click& click, float* sum) {
  for (std::size_t n = 0; n < click.size(); ++n) sum[n % kPoints] += click[n];
}

/// The sample that the engine starts it at.
long started(const PlayedClick& click) { return static_cast<long>(std::floor(click.time + 0.5)); }

void add_power(FramePair& transform, double share, Eigen::ArrayXd& power) {
  transform.forward();
  for (int k = 0; k < kSpectrumBins; ++k) power(k) += share * static_cast<double>(transform.power(k));
}

/// Mean of |G|^2 over the clicks.
Eigen::ArrayXd mean_click_power(const std::vector<Click>& clicks, FramePair& transform) {
  Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(kSpectrumBins);
  for (std::size_t c = 0; c < clicks.size(); c += 2) {
    transform.set({}, {});
    add_wrapped(clicks[c], transform.first());
    if (c + 1 < clicks.size()) add_wrapped(clicks[c + 1], transform.second());
    add_power(transform, 1 / static_cast<double>(clicks.size()), mean);
  }
  return mean;
}

/// |G|^2 of the clicks' sum.
Eigen::ArrayXd power_of_sum(const std::vector<Click>& clicks, FramePair& transform) {
  transform.set({}, {});
  for (const Click& click : clicks) add_wrapped(click, transform.first());
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(kSpectrumBins);
  add_power(transform, 1, power);
  return power;
}

/// Samples from one click to the next: a missed impact makes its gap longer, a double one comes within its
/// own.
double mean_gap(const ClickBank& bank) {
  return bank.mean_gap_samples * (1 + (kMissGap - 1) * bank.miss_share) / (1 + bank.double_share);
}

/// Mean square of as many unit clicks, each by itself.
double separate_power(const ClickBank& bank) {
  const double B = bank.mean_amplitude, sigma_B = bank.amplitude_deviation;
  return (B * B + sigma_B * sigma_B) / mean_gap(bank);
}

}  // namespace

ImpactPairs::ImpactPairs(const ClickBank& bank) : of_same(kSpectrumBins), of_other(kSpectrumBins) {
  const std::vector<PlayedClick> played = played_clicks(bank, kImpacts, kImpactSeed);
  double squares = 0;
  for (const PlayedClick& click : played) squares += click.amplitude * click.amplitude;
  FramePair transform(kPoints);
  transform.set({}, {});
  float *same = transform.first(), *other = transform.second();
  for (auto a = played.begin(); a != played.end(); ++a)
    for (auto b = a; b != played.end() && started(*b) - started(*a) < kPoints / 2; ++b) {
      const long lag = started(*b) - started(*a);
      const auto product = static_cast<float>(a->amplitude * b->amplitude / squares);
      float* pairs = a->click == b->click ? same : other;
      pairs[lag] += product;
      if (lag > 0) pairs[kPoints - lag] += product;
    }
  transform.forward();
  for (int k = 0; k < kSpectrumBins; ++k) {
    of_same(k) = static_cast<double>(transform.first_bin(k).real());
    of_other(k) = static_cast<double>(transform.second_bin(k).real());
  }
}

EndlessSpectrum::EndlessSpectrum(const ImpactPairs& pairs, const ClickBank& bank) {
  FramePair transform(kPoints);
  const Eigen::ArrayXd same = mean_click_power(bank.clicks, transform);
  power_ = pairs.of_same * same;
  const auto count = static_cast<double>(bank.clicks.size());
  if (count > 1)  // the mean of G conj(G') over all two that differ
    power_ += pairs.of_other * (power_of_sum(bank.clicks, transform) / count - same) / (count - 1);
  power_ *= separate_power(bank);
}

BandLevels EndlessSpectrum::third_octaves() const { return third_octave_levels_of(power_); }

double EndlessSpectrum::mean_square() const {
  return (2 * power_.sum() - power_(0) - power_(kSpectrumBins - 1)) / kPoints;
}

}  // namespace rigsound::analysis
