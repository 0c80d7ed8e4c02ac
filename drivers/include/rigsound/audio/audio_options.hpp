// The sound card a rig plays through.
#pragma once

#include <cstdint>
#include <string>

#include "rigsound/machine/limits.hpp"

namespace rigsound::audio {

/// kAuto takes the first of FLOAT, S32, S24_3, S16 that the device has.
enum class SampleFormat : std::uint8_t { kAuto, kFloat, kS32, kS24_3, kS16 };

constexpr Word<SampleFormat> kSampleFormats[] = {{"auto", SampleFormat::kAuto},
                                                 {"float", SampleFormat::kFloat},
                                                 {"s32", SampleFormat::kS32},
                                                 {"s24_3", SampleFormat::kS24_3},
                                                 {"s16", SampleFormat::kS16}};

struct AudioOptions {
  std::string device = "default";  ///< ALSA name, e.g. hw:CARD=PCH
  double rate = 48000;
  int block = 64;   ///< frames the engine computes at a time = one ALSA period of a raw card
  int periods = 3;  ///< blocks the device holds
  int channels = 2;
  SampleFormat format = SampleFormat::kAuto;
  bool resample = false;  ///< take a device of another rate and resample to it
};

template <class Archive>
void fields(Archive& a, AudioOptions& o) {
  a("device", o.device);
  a("rate", o.rate, kSampleRates.whole());
  a("block", o.block, kBlocks);
  a("periods", o.periods, Range{2, 32});
  a("channels", o.channels, kChannelCounts);
  a("format", o.format, kSampleFormats);
  a("resample", o.resample);
}

}  // namespace rigsound::audio
