// The steel that rings: geometry and the filters designed for it.
#pragma once

#include <string>

namespace rigsound {

/// A free-free steel bar (jackhammer paper, section 2), struck at its end.
struct ToolModel {
  std::string name;
  double length_m = 0.5;     ///< m, 0.3...1.0
  double diameter_m = 0.025; ///< m, 0.015...0.050
  double k_L = 0.94;         ///< reflection of the longitudinal loop
  double k_Tmin = 0.83;      ///< reflection of the transversal loop while the tool is in contact
  double k_Tmax = 0.89;      ///< and while it is free
};

}  // namespace rigsound
