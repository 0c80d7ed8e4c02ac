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

/// Everything in locals: a stored sample might change any member.
void BitContact::press(const double* down, double* up, int frames) noexcept {
  const double share = share_;
  double s = s_;
#pragma GCC unroll 4
  for (int n = 0; n < frames; ++n) {
    const double F_i = down[n], two = F_i + F_i;
    const double more = two > s ? (two - s) * share : 0;
    const double F = two > s ? s + more : two > 0 ? two : 0;
    s = F + more;
    up[n] = F - F_i;
  }
  s_ = s;
}

/// The bit moves by 2 F_i - F. Pulled off the rock it stands off, as far as the feed lets it.
void BitContact::rattle(const double* down, double* up, int frames) noexcept {
  const double share = share_, gap = gap_, back = gap_ * return_;
  double s = s_, off = off_;
#pragma GCC unroll 4
  for (int n = 0; n < frames; ++n) {
    const double F_i = down[n], two = F_i + F_i;
    if (off > 0) {
      off = std::min(std::max(off + (back - two), 0.0), gap);
      up[n] = -F_i;
    } else if (two > s) {
      const double more = (two - s) * share, F = s + more;
      s = F + more;
      up[n] = F - F_i;
    } else {
      s = two > 0 ? two : 0;
      if (two <= 0) off = std::min(back - two, gap);
      up[n] = s - F_i;
    }
  }
  s_ = s, off_ = off;
}

void BitContact::process(const double* down, double* up, int frames) noexcept {
  if (gap_ < 0) {
    for (int n = 0; n < frames; ++n) up[n] = -down[n];
    s_ = 0;
  } else if (gap_ == 0 && off_ == 0) {
    press(down, up, frames);
  } else {
    rattle(down, up, frames);
  }
}

}  // namespace rigsound::string
