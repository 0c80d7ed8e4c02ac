// The recursive filter 1/A(z) of a linear prediction.
#pragma once

#include <vector>

#include "dsp/lanes.hpp"

namespace rigsound::dsp {

class AllPole {
 public:
  /// `a`: a[0] = 1 ... a[p]. Thread: OFF.
  explicit AllPole(const std::vector<double>& a)
      : order_((static_cast<int>(a.size()) + 6) / 8 * 8), a_(static_cast<std::size_t>(order_), 0.0) {
    for (std::size_t k = 1; k < a.size(); ++k) a_[k - 1] = a[k];
    reset();
  }

  void reset() noexcept {
    past_.assign(static_cast<std::size_t>(2 * order_ + 1), 0.0);
    newest_ = order_;
  }

  /// y[n] = x[n] - sum_k a[k] y[n - k]. Thread: RT.
  double process(double x) noexcept {
    if (order_ == 0) return x;
    const double y = x - dot(a_.data(), past_.data() + newest_, order_);
    // Every value is kept twice so that the last `order` of them always lie in one run, newest first.
    newest_ = newest_ == 0 ? order_ - 1 : newest_ - 1;
    past_[static_cast<std::size_t>(newest_)] = y;
    past_[static_cast<std::size_t>(newest_ + order_)] = y;
    return y;
  }

 private:
  int order_, newest_ = 0;
  std::vector<double> a_, past_;
};

}  // namespace rigsound::dsp
