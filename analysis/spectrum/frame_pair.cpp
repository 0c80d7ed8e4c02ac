#include "spectrum/frame_pair.hpp"

namespace rigsound::analysis {

FramePair::FramePair(int size) : fft_(size), re_(size), im_(size) {}

std::complex<float> FramePair::first_bin(int k) const {
  const int m = mirrored(k);
  return {0.5f * (re_[k] + re_[m]), 0.5f * (im_[k] - im_[m])};
}

std::complex<float> FramePair::second_bin(int k) const {
  const int m = mirrored(k);
  return {0.5f * (im_[k] + im_[m]), 0.5f * (re_[m] - re_[k])};
}

float FramePair::power(int k) const {
  const int m = mirrored(k);
  return 0.5f * (re_[k] * re_[k] + im_[k] * im_[k] + re_[m] * re_[m] + im_[m] * im_[m]);
}

void FramePair::set_bins(int k, std::complex<float> first, std::complex<float> second) {
  const int m = mirrored(k);
  if (m == k) first.imag(0), second.imag(0);
  re_[k] = first.real() - second.imag(), im_[k] = first.imag() + second.real();
  re_[m] = first.real() + second.imag(), im_[m] = second.real() - first.imag();
}

void FramePair::inverse() {
  fft_.inverse(re_.data(), im_.data());
  const float share = 1 / static_cast<float>(size());
  for (float& x : re_) x *= share;
  for (float& x : im_) x *= share;
}

}  // namespace rigsound::analysis
