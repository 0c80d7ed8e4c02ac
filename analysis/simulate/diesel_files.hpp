// The simulated diesel as recordings: alone, with its speed, and with the truth a learner may be held
// against.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rigsound::analysis {

struct DieselFilesOptions {
  std::uint64_t seed = 1;
  /// Slow enough that 20 cycles and more lie within each 12 % of speed, which is what learn_diesel needs.
  double sweep_s = 75;
  double idle_s = 20;
};

/// Writes into `folder`/engine: sweep.wav, the diesel speeding up slowly from 600 to 2400 r/min with
/// sweep_rpm.csv (time_s,rpm), and idle.wav, steady at 800 r/min. Into `folder`/truth: engine_body.csv
/// (frequency_hz,gain_db), what the source goes through, and sweep_angle.csv and idle_angle.csv
/// (time_s,cycles of 720 degrees). Both folders exist. Returns one line a recording. Errors: DeviceError.
/// Thread: OFF.
std::vector<std::string> write_diesel(const std::filesystem::path& folder, const DieselFilesOptions& options);

}  // namespace rigsound::analysis
