// The hand that damps the bar: k_T falls while the hammer touches the steel and recovers after
// (jackhammer paper, section 3.4; a new touch falls from where k_T is, the paper's jump would click).
#pragma once

#include "rigsound/limits.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound::tool {

class Contact {
 public:
  Contact(const LoopDesign& loop, const Strike& strike, double sample_rate) noexcept
      : k_min_(loop.k_min),
        k_max_(loop.k_max),
        fall_((loop.k_max - loop.k_min) / (strike.fall_s * sample_rate)),
        rise_((loop.k_max - loop.k_min) / (strike.rise_s * sample_rate)),
        k_(loop.k_max) {}

  /// k_T of kChunk samples; `slope` > 0 where a touch begins, its factor on both ramps. Thread: RT.
  void process(const double* slope, double* k_T) noexcept {
    for (int n = 0; n < kChunk; ++n) {
      if (slope[n] > 0) slope_ = slope[n], falling_ = true;
      k_ += slope_ * (falling_ ? -fall_ : rise_);
      if (k_ <= k_min_) k_ = k_min_, falling_ = false;
      if (k_ > k_max_) k_ = k_max_;
      k_T[n] = k_;
    }
  }

 private:
  double k_min_, k_max_, fall_, rise_;  ///< steps a sample
  double k_, slope_ = 1;
  bool falling_ = false;
};

}  // namespace rigsound::tool
