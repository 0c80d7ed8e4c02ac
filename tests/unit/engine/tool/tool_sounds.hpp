// Sounds of the tool layer and of its loops, for tests and benchmarks to look at.
#pragma once

#include <functional>
#include <vector>

#include "tool/bar_loops.hpp"
#include "tool/tool_layer.hpp"

namespace rigsound::tests {

ToolModel model_of(const Bar& bar);

/// Without bounces and without chance.
ToolModel plain_model(const Bar& bar = {});

/// Plain, and its low modes ring for seconds, so that a change meets them in full voice. Two rods: a steel
/// that is 5 cm longer.
ToolModel long_ringing_model();

/// Curves of one chunk, and the drive that points at them.
struct Curves {
  double x[kChunk] = {}, k_T[kChunk], k_L[kChunk], mix[kChunk];

  Curves(double T, double L);
  tool::BarDrive drive(int frames = kChunk) const;
};

/// y of one family after a unit impulse, read from the delay line.
std::vector<double> impulse_response(const ToolDesign& design, tool::Family family, double k, int samples,
                                     dsp::LaneWidth width = dsp::widest_lanes());

struct Blows {
  double rate = 48000;
  double seconds = 0.5;
  double first_s = 0.00101;  ///< between two samples at every rate
  double period_s = 100;
};

/// The layer struck with even blows; `controls(t)` is asked once a chunk.
std::vector<double> struck(tool::ToolLayer& layer, const Blows& blows,
                           const std::function<tool::ToolInput(double)>& controls);

/// One blow on a new layer, nothing changed while it rings.
std::vector<double> one_blow(const ToolModel& model, double rate);

}  // namespace rigsound::tests
