// The hand that damps the bar: k_T falls while the hammer touches the steel and recovers after
// (jackhammer paper, section 3.4; a new touch falls from where k_T is, the paper's jump would click).
#pragma once

#include "rigsound/tool_model.hpp"
#include "tool/strikes.hpp"

namespace rigsound::tool {

class Contact {
 public:
  Contact(const LoopDesign& loop, const Strike& strike, double sample_rate) noexcept;

  /// k_T of kChunk samples. Thread: RT.
  void process(const Strikes& strikes, double* k_T) noexcept;

  bool rests() const noexcept { return !falling_ && k_ == k_max_; }  ///< nothing touches the bar

 private:
  void advance(int from, int to, double* k_T) noexcept;
  int ramp(int from, int to, double target, double step, double* k_T) noexcept;

  double k_min_, k_max_, fall_, rise_;  ///< steps a sample
  double k_, slope_ = 1;
  bool falling_ = false;
};

}  // namespace rigsound::tool
