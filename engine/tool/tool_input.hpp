// What the tool of one boom follows.
#pragma once

namespace rigsound::tool {

/// Neutral as it stands. A change of a gain or a factor is ramped.
struct ToolInput {
  double period = 2400;  ///< mean gap between blows, samples, > 0; bounces follow it
  double amplitude = 1;  ///< of the blows, 0...10
  double transversal_reflection = 1,
         longitudinal_reflection = 1;  ///< factors on the reflections, 0...1.2; none exceeds 0.9999
  double transversal_mix = 1, longitudinal_mix = 1;  ///< factors on the weights of the families, 0...10
  int rods = 1;                                      ///< on the string; picks the steel
};

}  // namespace rigsound::tool
