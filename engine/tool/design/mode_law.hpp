// Where the modes of a free-free steel bar lie, as a continuous function of the mode number.
#pragma once

#include <vector>

#include "rigsound/tool_model.hpp"

namespace rigsound::tool {

/// Frequency of one family of modes. Thread: OFF, CT.
class ModeLaw {
 public:
  virtual ~ModeLaw() = default;

  /// Hz at mode number `kappa` > 0; strictly rising, exact at the integers, which are the modes.
  virtual double at(double kappa) const = 0;

  /// How many modes lie below `hz`.
  int count_below(double hz) const;

  /// Modes per Hz at `kappa`: the round trip of a loop that has these modes, in seconds.
  double density(double kappa) const;
};

/// Bending. Exact free-free Timoshenko roots with Hutchinson's shear coefficient up to 20 kHz, the
/// Timoshenko dispersion relation between and above them. Against three-dimensional elasticity <= 1 cent
/// for the first ten modes below 18 kHz (bars of 0.3...1 m, 15...50 mm).
class TransversalLaw final : public ModeLaw {
 public:
  explicit TransversalLaw(const Bar& bar);
  double at(double kappa) const override;

 private:
  double correction(double kappa) const;

  Bar bar_;
  std::vector<double> correction_;  ///< ln(exact mode / dispersion relation) of modes 1, 2, ...
};

/// Stretching. Rayleigh-Love: eq. 1 of the paper with the inertia of the bar's sideways breathing;
/// <= 0.6 cent from three-dimensional elasticity, where eq. 1 is up to 11 cents sharp.
class LongitudinalLaw final : public ModeLaw {
 public:
  explicit LongitudinalLaw(const Bar& bar) : bar_(bar) {}
  double at(double kappa) const override;

 private:
  Bar bar_;
};

}  // namespace rigsound::tool
