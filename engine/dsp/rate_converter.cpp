#include "rigsound/dsp/rate_converter.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "rate_converter_rows.hpp"
#include "rigsound/dsp/interpolation_kernel.hpp"
#include "rigsound/dsp/lane_width.hpp"
#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {
namespace {

constexpr int kTaps = 48;
constexpr double kBeta = 9, kCut = 0.97;
constexpr std::int64_t kMostPhases = 640;  // more are interpolated, at -110 dB

/// The sinc is as long in periods of the lower rate, in whole steps of dot().
int taps_of(std::int64_t from_hz, std::int64_t to_hz) {
  const std::int64_t taps = kTaps * std::max(from_hz, to_hz) / to_hz;
  return static_cast<int>((taps + 7) / 8 * 8);
}

}  // namespace

RateConverter::RateConverter(std::int64_t from_hz, std::int64_t to_hz)
    : from_hz_(from_hz),
      up_(to_hz / std::gcd(from_hz, to_hz)),
      down_(from_hz / std::gcd(from_hz, to_hz)),
      taps_(taps_of(from_hz, to_hz)),
      weights_(static_cast<std::size_t>(up_ * taps_)) {
  const double ratio = static_cast<double>(to_hz) / static_cast<double>(from_hz);
  const InterpolationKernel kernel(taps_, static_cast<int>(std::min(up_, kMostPhases)), kBeta,
                                   kCut * std::min(1.0, ratio));
  before_ = -kernel.first();
  std::vector<double> exact(static_cast<std::size_t>(taps_));
  for (std::int64_t phase = 0; phase < up_; ++phase) {
    kernel.weights(static_cast<double>(phase) / static_cast<double>(up_), exact.data());
    std::copy(exact.begin(), exact.end(), weights_.begin() + phase * taps_);
  }
}

std::size_t RateConverter::converted_size(std::size_t samples) const noexcept {
  return static_cast<std::size_t>((static_cast<std::int64_t>(samples) * up_ + down_ - 1) / down_);
}

void RateConverter::convert(const float* signal, std::size_t samples, float* out) const {
  std::vector<float> x(samples + static_cast<std::size_t>(taps_ + 1), 0.0F);
  std::copy_n(signal, samples, x.begin() + before_);
  const PhaseRows rows{weights_.data(), up_, down_, taps_};
#ifdef RIGSOUND_AVX2
  if (widest_lanes() == LaneWidth::kFour)
    return convert_rows_eight(rows, x.data(), out, converted_size(samples));
#endif
  convert_rows<dot>(rows, x.data(), out, converted_size(samples));
}

std::vector<float> RateConverter::converted(const std::vector<float>& signal) const {
  std::vector<float> out(converted_size(signal.size()));
  convert(signal.data(), signal.size(), out.data());
  return out;
}

}  // namespace rigsound::dsp
