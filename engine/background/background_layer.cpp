#include "background/background_layer.hpp"

#include <algorithm>

namespace rigsound::background {
namespace {

constexpr std::size_t kCycle = 4096;    // samples a cycle
constexpr double kRpmSmoothing = 0.98;  // per chunk
constexpr double kNoisePole = 0.9;
constexpr double kRunning_rpm = 300;  // below it the engine is being cranked or dies away

}  // namespace

BackgroundLayer::BackgroundLayer(const std::vector<BackgroundModel>& models, double sample_rate,
                                 std::uint64_t seed)
    : sample_rate_(sample_rate), random_(seed, 4), cycle_(kCycle + 1, 0.0) {
  if (models.empty()) return;
  const BackgroundModel& model = models.front();
  model_rpm_ = model.rpm;
  noise_level_ = static_cast<double>(model.noise_level);
  for (std::size_t k = 0; k < model.order_amplitude.size(); ++k) {
    const double phase = dsp::kTwoPi * random_.uniform(k, 0);
    const auto amplitude = static_cast<double>(model.order_amplitude[k]);
    for (std::size_t n = 0; n <= kCycle; ++n)
      cycle_[n] +=
          amplitude * dsp::cos(dsp::kTwoPi * static_cast<double>((k + 1) * n % kCycle) / kCycle + phase);
  }
}

void BackgroundLayer::process(const BackgroundControls& controls, double* out) noexcept {
  if (controls.rpm < 1 && level_ < 1e-6) {
    std::fill(out, out + kChunk, 0.0);
    rpm_ = controls.rpm;
    return;
  }
  for (int n = 0; n < kChunk; ++n) {
    angle_ += rpm_ / (120 * sample_rate_);
    if (angle_ >= 1) angle_ -= 1;
    const double position = angle_ * kCycle;
    const auto i = static_cast<std::size_t>(position);
    const double fraction = position - std::floor(position);
    const double tone = cycle_[i] + (cycle_[i + 1] - cycle_[i]) * fraction;
    noise_ = noise_ * kNoisePole + (random_.uniform(sample_++, 1) - 0.5) * (1 - kNoisePole) * 12;
    out[n] = level_ * (tone + noise_level_ * (0.4 + controls.feed) * noise_);
  }
  rpm_ = controls.rpm + (rpm_ - controls.rpm) * kRpmSmoothing;
  const double level = std::min(1.0, rpm_ / kRunning_rpm) * (0.7 + 0.6 * controls.load);
  level_ = level + (level_ - level) * kRpmSmoothing;
}

}  // namespace rigsound::background
