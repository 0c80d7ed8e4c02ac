// Spectra of real frames, two for one complex transform.
#pragma once

#include <algorithm>
#include <complex>
#include <vector>

#include "rigsound/dsp/fft.hpp"

namespace rigsound::analysis {

/// One frame goes in as the real part, another as the imaginary part. Thread: OFF, one at a time.
class FramePair {
 public:
  explicit FramePair(int size);  ///< samples, a power of two

  int size() const { return fft_.size(); }

  /// Samples of both frames: what is missing is zero, what is too long is cut off.
  template <class First = std::vector<float>, class Second = std::vector<float>>
  void set(const First& first, const Second& second) {
    copy_padded(first, re_);
    copy_padded(second, im_);
  }

  /// `size` samples each; forward() and inverse() write over them.
  float* first() { return re_.data(); }
  float* second() { return im_.data(); }

  /// Spectra of both, not divided by the size.
  void forward() { fft_.forward(re_.data(), im_.data()); }

  /// Bin 0 ... size / 2 of each spectrum. Call after forward().
  std::complex<float> first_bin(int k) const {
    const int m = mirrored(k);
    return {0.5f * (re_[k] + re_[m]), 0.5f * (im_[k] - im_[m])};
  }
  std::complex<float> second_bin(int k) const {
    const int m = mirrored(k);
    return {0.5f * (im_[k] + im_[m]), 0.5f * (re_[m] - re_[k])};
  }
  /// The sum of both squared magnitudes there.
  float power(int k) const {
    const int m = mirrored(k);
    return 0.5f * (re_[k] * re_[k] + im_[k] * im_[k] + re_[m] * re_[m] + im_[m] * im_[m]);
  }

  /// Sets bin 0 ... size / 2 of both; the imaginary parts of bins 0 and size / 2 count for nothing.
  void set_bins(int k, std::complex<float> first, std::complex<float> second) {
    const int m = mirrored(k);
    if (m == k) first.imag(0), second.imag(0);
    re_[k] = first.real() - second.imag(), im_[k] = first.imag() + second.real();
    re_[m] = first.real() + second.imag(), im_[m] = second.real() - first.imag();
  }
  /// Both frames from their bins, divided by the size.
  void inverse();

 private:
  template <class Samples>
  static void copy_padded(const Samples& x, std::vector<float>& frame) {
    const auto end = std::copy_n(x.begin(), std::min(x.size(), frame.size()), frame.begin());
    std::fill(end, frame.end(), 0.0F);
  }

  int mirrored(int k) const { return (size() - k) & (size() - 1); }

  dsp::Fft<float> fft_;
  std::vector<float> re_, im_;
};

}  // namespace rigsound::analysis
