// What an engine is built with.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rigsound {

struct BoomOptions {
  std::string name = "boom";
  double pan = 0;  ///< -1 left ... +1 right, over the first two channels
  double gain_db = 0;
  int tool = -1;  ///< index into SoundSet::tools; -1: no ringing bar
};

/// When a drill is in which situation. Pressures in bar.
struct SceneOptions {
  double contact_bar = 15;              ///< over it the bit touches the rock
  double underfeed_bar = 60;            ///< below it: underfeed
  double overfeed_bar = 120;            ///< above it: overfeed
  double hysteresis_bar = 6;            ///< width of the band around each threshold
  double crossfade_s = 0.15;            ///< equal-power crossfade between situations
  double open_burst_s = 1.0;            ///< length of the burst that starts open rattling
  double open_sustain_db = -14;         ///< level after the burst
  double response_s = 0.08;             ///< time constant with which the drill follows the feed pressure
  double percussion_nominal_bar = 150;  ///< percussion pressure of banks that do not name theirs
  /// Feed pressure of banks that do not name theirs, bar; negative: the middle of their situation's band.
  double underfeed_point_bar = -1, normal_point_bar = -1, overfeed_point_bar = -1;
  double idle_rpm = 800;  ///< diesel at rest; under half of it the diesel is starting or stopping
};

struct EqualiserBand {
  double frequency_hz = 1000, gain_db = 0, q = 0.7;
};

struct MixOptions {
  double drill_db = 0, tool_db = -12, diesel_db = 0;
  std::vector<EqualiserBand> equaliser;
  double ceiling_dbfs = -1;  ///< no sample ever exceeds it
};

struct EngineOptions {
  double sample_rate = 48000;  ///< Hz, kMinSampleRate...kMaxSampleRate
  int block = 64;              ///< frames, a multiple of kChunk up to kMaxBlock
  int channels = 2;            ///< 1...kMaxChannels
  std::uint64_t seed = 1;      ///< same seed, same bits
  std::vector<BoomOptions> booms = {BoomOptions{}};
  SceneOptions scene;
  MixOptions mix;
};

}  // namespace rigsound
