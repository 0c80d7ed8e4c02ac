// A sound set learned from a simulated feed ramp, and what the engine makes of it at any feed.
#pragma once

#include <cstdint>
#include <filesystem>

#include "rigsound/sound_set.hpp"
#include "simulate/drilling_laws.hpp"

namespace rigsound::analysis {

struct RampRequest {
  std::uint64_t seed = 1;
  double seconds = 120;
  int jobs = 1;
};

/// Simulates a ramp into `folder`, analyses it by its bus log and loads what was written.
SoundSet learned_from_ramp(const std::filesystem::path& folder, const RampRequest& request);

struct HeardDrill {
  double rate_hz = 0, level_db = 0, decay = 0;  ///< level of the mean click's norm; alpha_d at 48 kHz
};

/// By the engine's feed axis: between banks what its draws come to on average, beyond them by the trends.
HeardDrill heard_at(const SoundSet& sounds, double feed_bar);

/// heard / true - 1, heard - true in dB, heard / true - 1.
struct HeardErrors {
  double rate = 0, level_db = 0, decay = 0;
};
HeardErrors errors_at(const SoundSet& sounds, const DrillingLaws& truth, double feed_bar);

}  // namespace rigsound::analysis
