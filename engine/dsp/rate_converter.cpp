#include "rigsound/dsp/rate_converter.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

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
      kernel_(taps_of(from_hz, to_hz), static_cast<int>(std::min(up_, kMostPhases)), kBeta,
              kCut * std::min(1.0, static_cast<double>(to_hz) / static_cast<double>(from_hz))) {}

std::vector<float> RateConverter::converted(const std::vector<float>& signal) const {
  const int taps = kernel_.taps(), before = -kernel_.first();
  std::vector<float> x(signal.size() + static_cast<std::size_t>(taps + 1), 0.0F),
      w(static_cast<std::size_t>(taps));
  std::vector<double> exact(w.size());
  std::copy(signal.begin(), signal.end(), x.begin() + before);
  const std::int64_t count = (static_cast<std::int64_t>(signal.size()) * up_ + down_ - 1) / down_;
  std::vector<float> out(static_cast<std::size_t>(count));
  // Samples of one phase share their weights.
  for (std::int64_t first = 0; first < std::min(up_, count); ++first) {
    kernel_.weights(static_cast<double>(first * down_ % up_) / static_cast<double>(up_), exact.data());
    std::copy(exact.begin(), exact.end(), w.begin());
    for (std::int64_t n = first; n < count; n += up_)
      out[static_cast<std::size_t>(n)] = dot(w.data(), x.data() + n * down_ / up_, taps);
  }
  return out;
}

}  // namespace rigsound::dsp
