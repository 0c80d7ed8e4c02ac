#include <samplerate.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "rigsound/config/bank_files.hpp"

namespace rigsound::config {
namespace {

std::vector<float> resampled_click(const std::vector<float>& click, double ratio) {
  std::vector<float> out(static_cast<std::size_t>(std::ceil(static_cast<double>(click.size()) * ratio)) + 1);
  SRC_DATA data{};
  data.data_in = click.data();
  data.data_out = out.data();
  data.input_frames = static_cast<long>(click.size());
  data.output_frames = static_cast<long>(out.size());
  data.src_ratio = ratio;
  if (const int error = src_simple(&data, SRC_SINC_BEST_QUALITY, 1); error != 0)
    throw std::runtime_error(std::string("a click cannot be resampled: ") + src_strerror(error));
  out.resize(static_cast<std::size_t>(data.output_frames_gen));

  double energy = 0;
  for (const float x : out) energy += static_cast<double>(x) * x;
  const double norm = std::sqrt(energy);
  if (norm > 0)
    for (float& x : out) x = static_cast<float>(x / norm);
  return out;
}

}  // namespace

ClickBank resampled(const ClickBank& bank, double sample_rate) {
  if (bank.sample_rate == sample_rate) return bank;
  const double ratio = sample_rate / bank.sample_rate;
  ClickBank out = bank;
  out.sample_rate = sample_rate;
  out.mean_gap_samples *= ratio;
  out.gap_deviation_samples *= ratio;
  out.attack_samples *= ratio;
  out.attack_bend /= ratio;
  out.decay /= ratio;
  // The same waveform has `ratio` times as many samples, so its L2 norm grows by the root of that.
  out.mean_amplitude *= std::sqrt(ratio);
  out.amplitude_deviation *= std::sqrt(ratio);
  for (std::vector<float>& click : out.clicks) click = resampled_click(click, ratio);
  return out;
}

}  // namespace rigsound::config
