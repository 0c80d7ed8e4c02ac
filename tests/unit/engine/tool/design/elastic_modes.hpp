// Modes of free-free steel cylinders by three methods, Hz: what the mode laws are held against.
#pragma once

#include <vector>

#include "rigsound/tool_model.hpp"

namespace rigsound::tests {

struct ReferenceBar {
  Bar bar;
  std::vector<double> rod;  ///< the rod theory the law follows: exact Timoshenko, or Rayleigh-Love
  std::vector<double>
      elastic;  ///< three-dimensional elasticity (Rayleigh-Ritz, circumferential order 1 or 0)
};

/// Rounded to 0.01 Hz, which is 0.25 cent at 69 Hz.
inline const std::vector<ReferenceBar> kTransversalReference = {
    {{0.30, 0.030},
     {1504.46, 3974.23, 7375.44, 11447.69, 15992.10},
     {1504.47, 3974.39, 7376.30, 11450.30, 15997.76}},
    {{0.50, 0.025},
     {459.91, 1253.05, 2416.39, 3911.89, 5702.03, 7748.04, 10012.84, 12462.50, 15066.95, 17800.16},
     {459.91, 1253.06, 2416.42, 3912.00, 5702.36, 7748.82, 10014.38, 12465.19, 15071.26, 17806.59}},
    {{0.70, 0.030},
     {282.06, 770.81, 1492.60, 2428.64, 3560.22, 4867.10, 6328.99, 7926.38, 9641.20, 11457.08},
     {282.06, 770.82, 1492.61, 2428.68, 3560.34, 4867.40, 6329.61, 7927.51, 9643.08, 11459.99}},
    {{1.00, 0.015},
     {69.39, 191.08, 374.01, 616.96, 919.23, 1279.91, 1697.93, 2172.09, 2701.04, 3283.37},
     {69.39, 191.08, 374.01, 616.96, 919.23, 1279.91, 1697.94, 2172.10, 2701.06, 3283.39}}};

/// Rayleigh-Love's are rounded to 0.1 Hz.
inline const std::vector<ReferenceBar> kLongitudinalReference = {
    {{0.30, 0.030}, {8661.9, 17295.0}, {8661.84, 17294.23}},
    {{0.50, 0.025}, {5199.3, 10394.2, 15580.6}, {5199.28, 10394.20, 15580.34}},
    {{1.00, 0.015},
     {2600.0, 5199.7, 7799.1, 10397.9, 12995.9, 15593.0},
     {2599.97, 5199.74, 7799.12, 10397.92, 12995.93, 15592.96}}};

}  // namespace rigsound::tests
