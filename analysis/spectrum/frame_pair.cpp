#include "spectrum/frame_pair.hpp"

namespace rigsound::analysis {

FramePair::FramePair(int size) : fft_(size), re_(size), im_(size) {}

void FramePair::inverse() {
  fft_.inverse(re_.data(), im_.data());
  const float share = 1 / static_cast<float>(size());
  for (float& x : re_) x *= share;
  for (float& x : im_) x *= share;
}

}  // namespace rigsound::analysis
