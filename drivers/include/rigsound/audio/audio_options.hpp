// The sound card a rig plays through.
#pragma once

#include <cstdint>
#include <string>

namespace rigsound::audio {

/// kAuto takes the first of FLOAT, S32, S24_3, S16 that the device has.
enum class SampleFormat : std::uint8_t { kAuto, kFloat, kS32, kS24_3, kS16 };

struct AudioOptions {
  std::string device = "default";  ///< ALSA name, e.g. hw:CARD=PCH
  double rate = 48000;             ///< Hz
  int block = 64;                  ///< frames the engine computes at a time = one ALSA period of a raw card
  int periods = 3;                 ///< blocks the device holds
  int channels = 2;
  SampleFormat format = SampleFormat::kAuto;
  bool resample = false;  ///< take a device of another rate and resample to it
};

}  // namespace rigsound::audio
