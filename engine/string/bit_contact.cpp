#include "string/bit_contact.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::string {

void BitContact::set_loading(double loading_samples) noexcept {
  const double K = 0.5 / loading_samples;
  if (K == K_) return;
  s_ *= std::sqrt(K / K_);
  K_ = K;
  share_ = K / (1 + K);
}

void BitContact::set_gap(double gap) noexcept {
  gap_ = gap;
  if (gap >= 0) off_ = std::min(off_, gap);
}

inline double BitContact::reflect(double F_i) noexcept {
  const double two = F_i + F_i;
  if (two > s_) {
    const double more = (two - s_) * share_;
    const double F = s_ + more;
    s_ = F + more;
    return F - F_i;
  }
  s_ = two > 0 ? two : 0;
  return s_ - F_i;
}

/// The bit moves by 2 F_i - F. Pulled off the rock it stands off, as far as the feed lets it.
inline double BitContact::reflect_across_gap(double F_i) noexcept {
  const double two = F_i + F_i;
  if (off_ > 0) {
    s_ = 0;
    off_ += (gap_ - off_) * return_ - two;
    off_ = std::min(std::max(off_, 0.0), gap_);
    return -F_i;
  }
  if (two < 0) off_ = std::min(-two, gap_);
  return reflect(F_i);
}

void BitContact::process(const double* down, double* up, int frames) noexcept {
  if (gap_ < 0) {
    for (int n = 0; n < frames; ++n) up[n] = -down[n];
    s_ = 0;
  } else if (gap_ == 0 && off_ == 0) {
    for (int n = 0; n < frames; ++n) up[n] = reflect(down[n]);
  } else {
    for (int n = 0; n < frames; ++n) up[n] = reflect_across_gap(down[n]);
  }
}

}  // namespace rigsound::string
