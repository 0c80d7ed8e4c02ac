// The recursive filter 1/A(z) of a linear prediction.
#pragma once

#include <algorithm>
#include <vector>

#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {

class AllPole {
 public:
  /// `a`: a[0] = 1 ... a[p]. Thread: OFF.
  explicit AllPole(const std::vector<double>& a)
      : order_((static_cast<int>(a.size()) + 6) / 8 * 8),
        a_(static_cast<std::size_t>(order_ + 1), 0.0),
        past_(static_cast<std::size_t>(2 * order_), 0.0) {
    for (std::size_t k = 1; k < a.size(); ++k) a_[k - 1] = a[k];
  }

  /// y[n] = x[n] - sum_k a[k] y[n - k] in place, `count` even. Thread: RT.
  void process(double* x, int count) noexcept {
    if (order_ == 0) return;
    for (int n = 0; n < count; n += 2) process_pair(x + n);
  }

  void reset() noexcept { std::fill(past_.begin(), past_.end(), 0.0); }

 private:
  /// Two samples share the loads of the past, and are stored as the one vector in which they are read again.
  void process_pair(double* x) noexcept {
    const double *a = a_.data(), *past = past_.data() + newest_;
    Lanes s0{}, s1{}, s2{}, s3{}, t0{}, t1{}, t2{}, t3{};
    for (int i = 0; i < order_; i += 8) {
      const Lanes p0 = load(past + i), p1 = load(past + i + 2), p2 = load(past + i + 4),
                  p3 = load(past + i + 6);
      s0 += load(a + i) * p0, t0 += load(a + i + 1) * p0;
      s1 += load(a + i + 2) * p1, t1 += load(a + i + 3) * p1;
      s2 += load(a + i + 4) * p2, t2 += load(a + i + 5) * p2;
      s3 += load(a + i + 6) * p3, t3 += load(a + i + 7) * p3;
    }
    const Lanes s = (s0 + s1) + (s2 + s3), t = (t0 + t1) + (t2 + t3);
    x[0] -= s[0] + s[1];
    x[1] -= (t[0] + t[1]) + a[0] * x[0];
    // Every value is kept twice so that the last `order` of them always lie in one run, newest first.
    newest_ = newest_ == 0 ? order_ - 2 : newest_ - 2;
    const Lanes y = {x[1], x[0]};
    store(past_.data() + newest_, y);
    store(past_.data() + newest_ + order_, y);
  }

  int order_, newest_ = 0;
  std::vector<double> a_, past_;
};

}  // namespace rigsound::dsp
