// A diesel with a known source and a known body: the truth the background model is held against.
#pragma once

#include <cstdint>
#include <vector>

namespace rigsound::analysis {

struct DieselRun {
  std::vector<double> rpm;  ///< r/min at every sample of kAnalysisRate
  double load = 0.5;        ///< 0...1: louder combustion
  double wander = 0.003;    ///< slow relative deviation of the speed, rms
  std::uint64_t seed = 1;   ///< the noises and the phase; the machine stays the same
};

struct DieselRecording {
  std::vector<double> sound;  ///< kAnalysisRate, peaks below full scale
  std::vector<double> theta;  ///< crank angle at every sample, cycles of 720 degrees
  std::vector<double> rpm;    ///< what the crank really did, wander included
};

/// Six cylinders, four strokes: firing pulses and valve ticks locked to the crank, combustion bursts, flow
/// noise, a nine-piston pump and a gear, all through the body. Everything in the source scales with the
/// crank, the body is fixed in Hz. Thread: OFF.
DieselRecording simulate_diesel(const DieselRun& run);

/// `seconds` at one speed, a straight ramp, and a glide that spends the same time in every octave. r/min at
/// every sample. Thread: OFF.
std::vector<double> steady_rpm(double rpm, double seconds);
std::vector<double> ramp_rpm(double from, double to, double seconds);
std::vector<double> glide_rpm(double from, double to, double seconds);

}  // namespace rigsound::analysis
