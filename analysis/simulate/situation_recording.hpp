// Simulated recordings of the five drilling situations of one machine.
#pragma once

#include <cstdint>
#include <vector>

#include "rigsound/machine/situation.hpp"
#include "simulate/click_voice.hpp"

namespace rigsound::analysis {

/// A stretch of drilling inside a recording, s.
struct SimulatedPart {
  double start, end;
};

struct SituationRecording {
  Situation situation = Situation::kNormal;
  int rods = 1;
  double feed_bar = 0;  ///< 0: rattling, whatever the feed
  double rate_hz = 0;   ///< impacts a second, those that do not come counted in
  double rpm = 0;       ///< r/min of the diesel in the middle of the recording
  ClickProcess process;
  ClickEnvelope envelope;
  std::vector<SimulatedPart> parts;
  std::vector<SimulatedClick> clicks;     ///< of all parts, ascending
  std::vector<double> clean, background;  ///< 48 kHz, full scale = 1; the recording is their sum
};

/// The machine is always the same: colours, modes and diesel orders do not depend on `seed`; impacts, noises
/// and the exact rate do. Drilling follows DrillingLaws at the feed of its situation; rattling is recorded
/// with one rod whatever `rods` says. `seconds` >= 4, `rods` 1...20. Thread: OFF.
SituationRecording simulate_situation(Situation situation, std::uint64_t seed, double seconds, int rods = 1);

}  // namespace rigsound::analysis
