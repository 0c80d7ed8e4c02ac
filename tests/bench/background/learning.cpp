#include "background/learning.hpp"

#include <fmt/format.h>

namespace rigsound::bench {

using namespace rigsound::analysis;

DieselTake simulated_take(const std::vector<double>& rpm, unsigned seed) {
  DieselRun run;
  run.rpm = rpm, run.seed = seed;
  const DieselRecording recording = simulate_diesel(run);
  DieselTake take;
  take.source = fmt::format("simulated {:.0f}", rpm.front());
  take.mono.assign(recording.sound.begin(), recording.sound.end());
  take.rpm = rpm.front();
  if (rpm.front() != rpm.back()) take.rpm_log = rpm;
  return take;
}

DieselTake steady_take(double rpm, double seconds, unsigned seed) {
  return simulated_take(steady_rpm(rpm, seconds), seed);
}

Section section_of(const DieselTake& take) {
  std::vector<std::string> warnings;
  return sections_of({take}, warnings).front();
}

}  // namespace rigsound::bench
