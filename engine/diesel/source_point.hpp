// A background point freed from the body, in logarithms: the form in which points are joined.
#pragma once

#include <algorithm>
#include <vector>

#include "rigsound/diesel_model.hpp"

namespace rigsound::diesel {

/// E(f) at any frequency, dB. Held at its ends, tapered by 1 / (1 + (f / 1600 Hz)^8). Thread: OFF.
double body_db(const BodyResponse& E, double f_hz);

/// Order-domain parameters at one speed and load with the body taken off: S in
/// 20 log |C_k| = S_k + E(k f). Joined as logarithms and wrapped phases; waveforms are never mixed.
struct SourcePoint {
  std::vector<double> level, phase;  ///< per order: ln |C_k|, arg C_k
  std::vector<double> lo, hi;        ///< ln sqrt v_lo, ln sqrt v_hi
  std::vector<double> s;             ///< sqrt s2
  double rho = 0;
};

/// `point` without the body of `model`. Thread: OFF.
SourcePoint source_of(const DieselModel& model, const DieselPoint& point);

/// The way from `a` to `b`, 0...1. Thread: OFF.
SourcePoint between(const SourcePoint& a, const SourcePoint& b, double way);

/// The sources of all points of a model. Thread: OFF.
class SourceMap {
 public:
  explicit SourceMap(const DieselModel& model);

  /// At any speed and load: between the two nearest speeds (in logarithm) of the two nearest loads, held
  /// outside.
  SourcePoint at(double rpm, double load) const;

  /// The nearest speed that lies between points: at() is the same there.
  double held(double rpm) const { return std::clamp(rpm, slowest_rpm_, fastest_rpm_); }

 private:
  struct Known {
    double rpm;
    SourcePoint source;
  };
  struct Row {
    double load;
    std::vector<Known> points;  ///< by speed
  };

  static SourcePoint along(const Row& row, double rpm);

  std::vector<Row> rows_;  ///< by load
  double slowest_rpm_, fastest_rpm_;
};

}  // namespace rigsound::diesel
