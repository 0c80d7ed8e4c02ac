// A stretch of a recording at one speed, with the crank angle of every sample.
#pragma once

#include <string>
#include <vector>

#include "rigsound/analysis/diesel.hpp"

namespace rigsound::analysis {

struct Section {
  std::string source;
  int take = 0;               ///< sections of one take share its crank origin
  std::vector<double> x;      ///< samples, kAnalysisRate
  std::vector<double> theta;  ///< cycles at every sample
  std::vector<char> open;     ///< per sample: not under an impact; empty: all of it
  double nyquist_hz = 24000;  ///< of the source
  double load = 0, correlation = 0;
  bool run_up = false;

  double f0() const;  ///< mean cycles a second
};

/// Tracks every take and cuts run-ups where the speed has changed by 12 %. Adds to `warnings`.
/// Errors: InputError. Thread: OFF.
std::vector<Section> sections_of(const std::vector<DieselTake>& takes, std::vector<std::string>& warnings,
                                 const Progress& progress = {});

/// A section cut into whole cycles from a common crank origin.
struct CycleBlock {
  int N = 0;  ///< angle samples a cycle
  int cycles = 0;
  double origin = 0;       ///< theta of its first sample
  std::vector<double> y;   ///< cycles x N
  std::vector<char> open;  ///< per angle sample; empty: all
};

/// `x`: one value a sample of the section (the sound, or something made of it). `origin`: 0...1 of a cycle.
CycleBlock cycles_of(const Section& section, const std::vector<double>& x, double origin, int N);

}  // namespace rigsound::analysis
