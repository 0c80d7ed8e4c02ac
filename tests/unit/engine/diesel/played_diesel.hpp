// What a diesel layer plays, and how loud it is.
#pragma once

#include <vector>

#include "diesel/diesel_layer.hpp"
#include "engine/heard.hpp"

namespace rigsound::tests {

inline std::vector<double> play(diesel::DieselLayer& layer, const DieselInput& controls, double seconds) {
  std::vector<double> out(static_cast<std::size_t>(seconds * kRate / kChunk) * kChunk);
  for (std::size_t n = 0; n < out.size(); n += kChunk) layer.process(controls, &out[n]);
  return out;
}

/// Mean square from sample `from` on.
inline double power(const std::vector<double>& x, std::size_t from = 0) {
  double sum = 0;
  for (std::size_t n = from; n < x.size(); ++n) sum += x[n] * x[n];
  return sum / static_cast<double>(x.size() - from);
}

}  // namespace rigsound::tests
