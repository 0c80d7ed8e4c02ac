// Recordings that come with their truth: for the demo, the tests, and those who have no recordings yet.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/progress.hpp"

namespace rigsound::analysis {

/// Writes one recording per situation into `folder`: NAME.wav, NAME.txt (Audacity labels), and under truth/
/// the clean sound, the background, NAME_truth.csv (time_s,amplitude,kind), NAME_envelope.csv and
/// NAME_parameters.csv; under engine/ a diesel alone, idling and speeding up, with its r/min, and under
/// truth/ its crank angle and body. Returns one line per recording. Errors: DeviceError when the folder
/// cannot be written. Thread: OFF.
std::vector<std::string> write_situations(const std::filesystem::path& folder, std::uint64_t seed,
                                          double seconds, const Progress& progress = {});

/// Writes a recording along a feed ramp from 35 to 165 bar with one rod, drilling 6 dB over the background at
/// the normal feed: feed/ramp.wav, .txt (a label every 10 bar) and .log (what a bus of config/dbc/rig.dbc
/// said meanwhile), and under truth/ feed_ramp_clean.wav, _background.wav, _truth.csv, _feed.csv
/// (time_s,feed_bar), _laws.csv (rate, level, decay, brightness, missed impacts over the feed) and
/// _slopes.csv (the laws as soundset.toml has them). `seconds` >= 10. Returns and errors: as above. Thread:
/// OFF.
std::vector<std::string> write_feed_ramp(const std::filesystem::path& folder, std::uint64_t seed,
                                         double seconds);

/// Writes underfeed, normal and overfeed of each rod count into rods/: rodsN_NAME.wav, .txt and their truth,
/// as write_situations does. `counts` 1...20. Thread: OFF.
std::vector<std::string> write_rods(const std::filesystem::path& folder, std::uint64_t seed,
                                    const std::vector<int>& counts, double seconds,
                                    const Progress& progress = {});

struct DrillBenchRequest {
  std::vector<int> ids;
  std::vector<std::string> snr_db;  ///< as written: they name the files
  double seconds = 2;
  double rate_factor = 1;  ///< impacts this much closer together
};

/// Writes cNNN_clean.wav, cNNN_bg.wav, cNNN_SNR.wav and cNNN_truth.csv for every id. Returns one line per
/// clip. Errors: InputError for an id or a ratio that does not exist, DeviceError for the folder. Thread:
/// OFF.
std::vector<std::string> write_drillbench(const std::filesystem::path& folder,
                                          const DrillBenchRequest& request, const Progress& progress = {});

}  // namespace rigsound::analysis
