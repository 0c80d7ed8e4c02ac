// Finds delay and allpass of a loop whose poles are the modes of a law.
#pragma once

#include "rigsound/tool_design.hpp"
#include "tool/design/mode_law.hpp"

namespace rigsound::tool {

struct LoopTask {
  double sample_rate = 48000;
  LoopFilters filters;                ///< already chosen; their lag is part of what the allpass makes up for
  double k_min = 0.83, k_max = 0.89;  ///< poles are tuned half-way between
  double cents = 0.3;                 ///< aim for the worst mode
  double cents_limit = 1.0;           ///< accepted when the aim is not reached within preferred_order
  double decay_share = 0.03;    ///< worst deviation of a mode's T60 from that of the ideal loop; one half
                                ///< if no order does better (bars below 0.3 m, T60 of a few ms)
  double beside_weight = 0.05;  ///< of the lag beside a mode, which keeps the decays even
  int lowest_order = 2, preferred_order = 30, max_order = 2 * kMaxSections;
  double spare_delay = 0.8;  ///< search starts with this share of the top round trip left to the delay line
};

/// How far a loop is from its law, over all modes below mode_limit().
struct LoopError {
  double cents = 0;        ///< worst pole, with k half-way
  double decay_share = 0;  ///< worst |T60 / T60 of a loop with the law's own round trip - 1|
};

struct DesignedLoop {
  LoopDesign loop;
  LoopError error;
};

/// Modes above are nobody's target: 18 kHz or 0.41 of the sample rate.
double mode_limit(double sample_rate);

/// T60 in samples that mode `mode` has in a loop with the law's own round trip, these filters and this k.
double ideal_t60_samples(const ModeLaw& law, const LoopFilters& filters, double k, int mode,
                         double sample_rate);

/// Searches the shortest allpass that reaches task.cents, else the best within cents_limit. Throws
/// std::invalid_argument when none is, or when the law has no mode to tune. Thread: OFF, CT.
DesignedLoop design_loop(const ModeLaw& law, const LoopTask& task);

/// `loop` with other filters or k: the allpass is fitted again from where it stands, its order and delay
/// stay. Thread: OFF, CT.
DesignedLoop retune_loop(const ModeLaw& law, const LoopTask& task, const LoopDesign& loop);

}  // namespace rigsound::tool
