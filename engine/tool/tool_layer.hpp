// The ringing bar of one boom.
#pragma once

#include <array>
#include <vector>

#include "rigsound/impact.hpp"
#include "rigsound/limits.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound::tool {

/// The paper's bar: two delay loops, longitudinal and transversal, struck by Hann pulses
/// (jackhammer paper, section 2).
class ToolLayer {
 public:
  ToolLayer(const ToolModel& model, double sample_rate);  ///< Thread: OFF

  /// The next kChunk samples, struck by `count` impacts. Thread: RT.
  void process(const Impact* impacts, int count, double* out) noexcept;

 private:
  struct Loop {
    std::vector<double> delay;
    std::size_t at = 0;
    double reflection = 0, dc_in = 0, dc_out = 0;
    std::array<double, 4> allpass{};
    double process(double x) noexcept;
  };

  Loop longitudinal_, transversal_;
  double pulse_samples_;
  std::array<double, kMaxImpacts> age_{};  ///< samples since each recent impact
  std::array<double, kMaxImpacts> strength_{};
  std::size_t next_ = 0;
  double high_in_ = 0, high_out_ = 0, high_pole_;
};

}  // namespace rigsound::tool
