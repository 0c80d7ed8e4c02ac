#include "diesel/start_stop.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/interpolation_kernel.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::diesel {
namespace {

constexpr double kFade_s = 0.04;
constexpr double kHandover_s = 0.3;  // before the start's end the running engine comes in
constexpr double kTurning_rpm = 20;  // from here on somebody cranks
constexpr double kStands_rpm = 1;
constexpr double kArrived = 1e-5;  // an exponential never does

std::vector<float> at_rate(const std::vector<float>& x, double from, double to) {
  if (from == to || x.empty()) return x;
  const dsp::InterpolationKernel kernel(32, 256, 10, std::min(1.0, to / from) * 0.92);
  std::vector<double> w(static_cast<std::size_t>(kernel.taps()));
  std::vector<float> y(static_cast<std::size_t>(static_cast<double>(x.size()) * to / from));
  for (std::size_t n = 0; n < y.size(); ++n) {
    const double position = static_cast<double>(n) * from / to;
    const double whole = std::floor(position);
    kernel.weights(position - whole, w.data());
    double sum = 0;
    for (int k = 0; k < kernel.taps(); ++k) {
      const auto i = static_cast<std::ptrdiff_t>(whole) + kernel.first() + k;
      if (i >= 0 && i < static_cast<std::ptrdiff_t>(x.size()))
        sum += w[static_cast<std::size_t>(k)] * static_cast<double>(x[static_cast<std::size_t>(i)]);
    }
    y[n] = static_cast<float>(sum);
  }
  return y;
}

}  // namespace

StartStop::StartStop(const DieselModel& model, double sample_rate, double idle_rpm)
    : start_(at_rate(model.start, model.sample_rate, sample_rate)),
      stop_(at_rate(model.stop, model.sample_rate, sample_rate)),
      running_rpm_(idle_rpm / 2),
      smoothing_(dsp::one_pole_remainder(kFade_s, kChunk, sample_rate)),
      fade_(1 / (kFade_s * sample_rate)),
      handover_(kHandover_s * sample_rate) {}

/// One chunk, fading when it was broken off.
void StartStop::Shot::add(double fade, double* out) noexcept {
  if (!sounds()) return;
  const std::size_t count = std::min<std::size_t>(kChunk, samples->size() - at);
  for (std::size_t n = 0; n < count; ++n) {
    gain = broken_off ? std::max(0.0, gain - fade) : gain;
    out[n] += gain * static_cast<double>((*samples)[at + n]);
  }
  at += count;
  if (at == samples->size() || gain == 0) samples = nullptr;
}

void StartStop::play(const std::vector<float>& samples, Phase phase) noexcept {
  break_off();
  phase_ = phase;
  if (!samples.empty()) shot_.samples = &samples;
}

void StartStop::break_off() noexcept {
  if (shot_.sounds()) leaving_ = shot_, leaving_.broken_off = true;
  shot_ = Shot();
}

double StartStop::target(double rpm) const noexcept {
  if (phase_ == Phase::kOff) return 0;
  if (phase_ == Phase::kStopping && shot_.sounds()) return 0;
  if (phase_ == Phase::kStarting && static_cast<double>(shot_.left()) > handover_) return 0;
  return std::min(1.0, rpm / running_rpm_);
}

void StartStop::follow(double rpm) noexcept {
  const bool at_rest = phase_ == Phase::kOff && rpm > kTurning_rpm;
  const bool again = phase_ == Phase::kStopping && rpm > running_rpm_;
  if (at_rest || again) play(start_, Phase::kStarting);
  if (phase_ == Phase::kStarting && !shot_.sounds() && rpm > running_rpm_) phase_ = Phase::kRunning;
  if (phase_ == Phase::kStarting && rpm < kStands_rpm) break_off();  // it did not catch
  if (phase_ == Phase::kRunning && rpm < running_rpm_) play(stop_, Phase::kStopping);
  if (rpm < kStands_rpm && !shot_.sounds()) phase_ = Phase::kOff;
}

void StartStop::advance(double rpm) noexcept {
  follow(rpm);
  const double wanted = target(rpm);
  gain_.go_to(dsp::approached(gain_.to, wanted, smoothing_));
  if (std::fabs(gain_.to - wanted) < kArrived) gain_.to = wanted;
}

void StartStop::add_to(double* out) noexcept {
  shot_.add(fade_, out);
  leaving_.add(fade_, out);
}

}  // namespace rigsound::diesel
