#include "sound_set/bank_resampling.hpp"

#include <cmath>

#include "rigsound/dsp/energy.hpp"

namespace rigsound::config {
namespace {

void set_unit_norm(std::vector<float>& click) {
  const double norm = std::sqrt(dsp::energy(click));
  if (norm > 0)
    for (float& x : click) x = static_cast<float>(x / norm);
}

}  // namespace

ClickBank BankResampler::resampled(ClickBank bank) {
  if (bank.sample_rate == sample_rate_) return bank;
  const auto from = std::lround(bank.sample_rate), to = std::lround(sample_rate_);
  if (!converter_ || converter_->from_hz() != from) converter_.emplace(from, to);
  const double ratio = sample_rate_ / bank.sample_rate;
  bank.sample_rate = sample_rate_;
  bank.mean_gap_samples *= ratio;
  bank.gap_deviation_samples *= ratio;
  bank.attack_samples *= ratio;
  bank.attack_bend /= ratio;
  bank.decay /= ratio;
  // The same waveform has `ratio` times as many samples, so its L2 norm grows by the root of that.
  bank.mean_amplitude *= std::sqrt(ratio);
  bank.amplitude_deviation *= std::sqrt(ratio);
  for (std::vector<float>& click : bank.clicks) {
    click = converter_->converted(click);
    set_unit_norm(click);
  }
  return bank;
}

}  // namespace rigsound::config
