// The sounds of one trial of a listening test: excerpts of one place and length, levels matched. Thread: any.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "workplace.hpp"

namespace rigsound::studio {

/// What is compared. The anchor is the recorded one below 3.5 kHz.
const std::vector<std::string>& trial_kinds();

struct TrialRequest {
  std::string bank;
  std::vector<std::string> kinds;  ///< the others are made as loud as the first
  double from_s = 0, seconds = 0;
};

struct TrialSounds {
  double seconds = 0;                        ///< at most what was asked for: to the end of the part
  std::map<std::string, std::string> waves;  ///< of each kind, the bytes of a WAV, 48 kHz, mono
  std::map<std::string, double> gains_db;    ///< that went into them
};

/// Errors: ApiError 400 behind the end of the part, 404 without bank or recording, 422 for a bank that is not
/// at 48 kHz; InputError.
TrialSounds trial_sounds(Workplace& place, const TrialRequest& request);

}  // namespace rigsound::studio
