#include "sound_set/bank_resampling.hpp"

#include <cmath>

#include "rigsound/dsp/energy.hpp"

namespace rigsound::config {
namespace {

void set_unit_norm(float* click, std::size_t samples) {
  const double norm = std::sqrt(dsp::energy(click, samples));
  if (norm > 0) dsp::divide(click, samples, norm);
}

}  // namespace

Click BankResampler::resampled(const Click& click) {
  const std::size_t samples = converter_->converted_size(click.size());
  const std::shared_ptr<float> made = store_.room(samples);
  converter_->convert(click.data(), click.size(), made.get());
  set_unit_norm(made.get(), samples);
  return {made, samples};
}

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
  for (Click& click : bank.clicks) click = resampled(click);
  return bank;
}

}  // namespace rigsound::config
