// The real-time engine: machine state in, one fixed block of samples out.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/machine_state.hpp"
#include "rigsound/sound_set.hpp"

namespace rigsound {

struct BoomOptions {
  std::string name = "boom";
  double pan = 0;  ///< -1 left ... +1 right, over the first two channels
  double gain_db = 0;
  int tool = -1;  ///< index into SoundSet::tools; -1: no ringing bar
};

/// When a drill is in which situation. Pressures in bar.
struct SceneOptions {
  double contact_bar = 15;       ///< over it the bit touches the rock
  double underfeed_bar = 60;     ///< below it: underfeed
  double overfeed_bar = 120;     ///< above it: overfeed
  double hysteresis_bar = 6;     ///< width of the band around each threshold
  double crossfade_s = 0.15;     ///< equal-power crossfade between situations
  double open_burst_s = 1.0;     ///< length of the burst that starts open rattling
  double open_sustain_db = -14;  ///< level after the burst
  double idle_rpm = 800;         ///< diesel at rest; under half of it the diesel is starting or stopping
};

struct EqualiserBand {
  double frequency_hz = 1000, gain_db = 0, q = 0.7;
};

struct MixOptions {
  double drill_db = 0, tool_db = -12, background_db = 0;
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

/// What the last block was like. Thread: RT (the thread that calls process).
struct EngineMeters {
  float peak = 0;  ///< of the last block, linear, after the limiter
  float rms = 0;
  float limiter_gain = 1;         ///< lowest of the last block, linear
  std::uint64_t lost_clicks = 0;  ///< clicks dropped because every voice was busy, since construction
};

class Engine {
 public:
  /// Builds every table and voice. Throws std::invalid_argument when an option is out of range or the
  /// sound set has no bank for a situation. Thread: OFF.
  Engine(const EngineOptions& options, SoundSet sounds);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  /// One block. `out`: block x channels samples, interleaved, |sample| <= ceiling. `state` acts from the
  /// first sample on. Never allocates, locks, throws or calls libm. Thread: RT.
  void process(const MachineState& state, float* out) noexcept;

  EngineMeters meters() const noexcept;  ///< Thread: RT
  const EngineOptions& options() const noexcept;

 private:
  struct Rooms;
  std::unique_ptr<Rooms> rooms_;
};

}  // namespace rigsound
