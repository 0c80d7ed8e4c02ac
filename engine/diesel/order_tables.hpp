// One cycle of the orders of operating states, as the crank angle reads it.
#pragma once

#include <vector>

#include "diesel/source_point.hpp"
#include "rigsound/dsp/fft.hpp"

namespace rigsound::diesel {

/// Tables of two states by one transform: one becomes its real part, the other its imaginary part. Thread:
/// OFF.
class OrderTables {
 public:
  /// The orders of a point without the body, each as ln |C_k| and C_k / |C_k|.
  struct Source {
    explicit Source(const SourcePoint& point);

    std::vector<double> level, re, im;
  };

  /// `model` outlives it.
  OrderTables(const DieselModel& model, double sample_rate);

  /// The orders of the first or the second state, at `f` cycles per second, with the body on them; those that
  /// would fold over fade out.
  void put(bool second, const Source& source, double f);

  /// One cycle of each, N_theta samples; that of a state not put is rounding. Then it is empty again.
  void take(std::vector<float>& first, std::vector<float>& second);

 private:
  const DieselModel& model_;
  double sample_rate_;
  dsp::Fft<double> fft_;
  std::vector<double> re_, im_;  ///< of the first plus i times the second, each with its mirror image
};

}  // namespace rigsound::diesel
