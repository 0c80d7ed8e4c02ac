#include "simulate/diesel_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "simulate/diesel_recording.hpp"
#include "simulate/truth_files.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

constexpr double kLow_rpm = 600, kTop_rpm = 2400, kIdle_rpm = 800;

std::string write_run(const fs::path& folder, const std::string& stem, const DieselRun& run) {
  const DieselRecording recording = simulate_diesel(run);
  write_wave(folder / "engine" / (stem + ".wav"), recording.sound, static_cast<int>(kAnalysisRate));
  write_track_csv(folder / "truth" / (stem + "_angle.csv"), "cycles", recording.theta);
  return fmt::format("engine/{}.wav rpm={:.0f}..{:.0f}", stem, run.rpm.front(), run.rpm.back());
}

}  // namespace

std::vector<std::string> write_diesel(const fs::path& folder, const DieselFilesOptions& options) {
  DieselRun sweep, idle;
  sweep.rpm = glide_rpm(kLow_rpm, kTop_rpm, options.sweep_s);
  idle.rpm = steady_rpm(kIdle_rpm, options.idle_s);
  sweep.seed = 2 * options.seed;
  idle.seed = 2 * options.seed + 1;
  write_track_csv(folder / "engine" / "sweep_rpm.csv", "rpm", sweep.rpm);
  write_body_csv(folder / "truth" / "engine_body.csv");
  return {write_run(folder, "sweep", sweep), write_run(folder, "idle", idle)};
}

}  // namespace rigsound::analysis
