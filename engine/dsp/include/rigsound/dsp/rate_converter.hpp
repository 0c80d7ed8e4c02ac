// A whole signal at another sampling rate: windowed sinc, one row of weights a phase.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigsound::dsp {

/// Flat to 0.85 of the lower of both Nyquist frequencies (18.7 kHz from 44.1 to 48 kHz) within 0.01 dB, -90
/// dB from 1.1 of it on. Sample 0 stays sample 0.
class RateConverter {
 public:
  /// Rates in whole Hz. Thread: OFF.
  RateConverter(std::int64_t from_hz, std::int64_t to_hz);

  std::int64_t from_hz() const noexcept { return from_hz_; }

  /// As many samples as last as long as `samples`, rounded up. Thread: any.
  std::size_t converted_size(std::size_t samples) const noexcept;

  /// `samples` of `signal` into converted_size(samples) of `out`. Thread: OFF.
  void convert(const float* signal, std::size_t samples, float* out) const;
  std::vector<float> converted(const std::vector<float>& signal) const;

 private:
  std::int64_t from_hz_;
  std::int64_t up_, down_;      ///< in lowest terms: `up_` samples come of `down_`
  int taps_, before_ = 0;       ///< of them before the sample
  std::vector<float> weights_;  ///< up_ x taps_
};

}  // namespace rigsound::dsp
