// A bank played offline, by the engine itself.
#pragma once

#include <cstdint>
#include <vector>

#include "rigsound/click_bank.hpp"
#include "rigsound/machine/machine_state.hpp"
#include "rigsound/progress.hpp"

namespace rigsound::analysis {

struct ResynthImpact {
  double time = 0;       ///< samples at the bank's rate, not rounded
  double amplitude = 1;  ///< relative to the mean impact
};

struct Resynthesis {
  std::vector<float> sound;            ///< at the bank's rate, full scale 1
  std::vector<ResynthImpact> impacts;  ///< the impacts in it
};

/// `seconds` of the bank under the paper's six controls: the same samples the engine plays live with that
/// seed. Errors: InputError when the bank cannot be played. Thread: OFF.
Resynthesis resynthesise(const ClickBank& bank, double seconds, std::uint64_t seed,
                         const DrillControls& controls = {}, const Progress& progress = {});

struct PlayedClick {
  double time = 0;        ///< of its impact, samples at the bank's rate, not rounded
  double amplitude = 1;   ///< relative to the mean impact
  std::size_t click = 0;  ///< of the bank
};

/// The first `count` clicks of resynthesise() with that seed and plain controls, without its sound. Errors:
/// InputError when the bank cannot be played. Thread: OFF.
std::vector<PlayedClick> played_clicks(const ClickBank& bank, std::size_t count, std::uint64_t seed);

}  // namespace rigsound::analysis
