// What an engine is built with. Ranges and units stand in the lists (rigsound/machine/fields.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/machine/limits.hpp"

namespace rigsound {

constexpr Range kLayerGain{-60, 24, "dB"};
constexpr Range kFeedPressures{0, 300, "bar"};

struct BoomOptions {
  std::string name = "boom";
  double pan = 0;  ///< -1 left ... +1 right, over the first two channels
  double gain_db = 0;
  int tool = -1;          ///< index into SoundSet::tools; -1: no ringing bar
  int drill_string = -1;  ///< index into SoundSet::strings; -1: no ringing string
};

template <class Archive>
void fields(Archive& a, BoomOptions& o) {
  a("name", o.name, Label{});
  a("pan", o.pan, Range{-1, 1});
  a("gain_db", o.gain_db, kLayerGain);
}

/// Feed pressure of banks that do not name theirs; 0: where the thresholds put their situation.
struct FeedPointOptions {
  double underfeed = 0, normal = 0, overfeed = 0;
};

template <class Archive>
void fields(Archive& a, FeedPointOptions& o) {
  a("underfeed", o.underfeed, kFeedPressures.or_zero());
  a("normal", o.normal, kFeedPressures.or_zero());
  a("overfeed", o.overfeed, kFeedPressures.or_zero());
}

/// When a drill is in which situation: contact < underfeed <= overfeed.
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
  FeedPointOptions feed_points;
  double idle_rpm = 800;  ///< diesel at rest; under half of it the diesel is starting or stopping
};

template <class Archive>
void fields(Archive& a, SceneOptions& o) {
  a("contact_bar", o.contact_bar, kFeedPressures);
  a("underfeed_bar", o.underfeed_bar, kFeedPressures);
  a("overfeed_bar", o.overfeed_bar, kFeedPressures);
  a("hysteresis_bar", o.hysteresis_bar, Range{0, 100, "bar"});
  a("crossfade_s", o.crossfade_s, Range{0, 10, "s"});
  a("open_burst_s", o.open_burst_s, Range{0, 10, "s"});
  a("open_sustain_db", o.open_sustain_db, Range{-60, 0, "dB"});
  a("response_s", o.response_s, Range{0, 10, "s"});
  a("percussion_nominal_bar", o.percussion_nominal_bar, Range{10, 300, "bar"});
  a("feed_points", o.feed_points);
  a("idle_rpm", o.idle_rpm, kIdleSpeeds);
}

/// A bell, at most at kHighestCorner of the sample rate.
struct EqualiserBand {
  double frequency_hz = 1000, gain_db = 0, q = 0.7;
};

template <class Archive>
void fields(Archive& a, EqualiserBand& o) {
  a("frequency_hz", o.frequency_hz, Range{10, kHighestCorner * kMaxSampleRate, "Hz"});
  a("gain_db", o.gain_db, Range{-24, 24, "dB"});
  a("q", o.q, Range{0.1, 20});
}

struct MixOptions {
  double drill_db = 0, tool_db = -12, diesel_db = 0;
  std::vector<EqualiserBand> equaliser;
  double ceiling_dbfs = -1;    ///< no sample and no true peak ever exceeds it
  double lookahead_s = 0.002;  ///< of the limiter; 0: none, and it limits samples only
};

template <class Archive>
void fields(Archive& a, MixOptions& o) {
  a("drill_db", o.drill_db, kLayerGain);
  a("tool_db", o.tool_db, kLayerGain);
  a("background_db", o.diesel_db, kLayerGain);
  a("ceiling_dbfs", o.ceiling_dbfs, Range{-60, 0, "dBFS"});
  a("lookahead_s", o.lookahead_s, Range{0.002, 0.02, "s"}.or_zero());
  a("equaliser", o.equaliser);
}

struct EngineOptions {
  double sample_rate = 48000;
  int block = 64;
  int channels = 2;
  std::uint64_t seed = 1;                            ///< any; same seed, same bits
  std::vector<BoomOptions> booms = {BoomOptions{}};  ///< 1...kMaxBooms
  SceneOptions scene;
  MixOptions mix;
};

/// How much later everything sounds so that the limiter can look ahead: whole chunks. Thread: any.
inline int lookahead_frames(const EngineOptions& o) noexcept {
  if (o.mix.lookahead_s == 0) return 0;
  const double chunks = std::ceil(o.mix.lookahead_s * o.sample_rate / kChunk - 1e-9);
  return kChunk * std::max(kLeastLookahead, static_cast<int>(chunks));
}

/// The seed apart, which may be chosen per run.
template <class Archive>
void fields(Archive& a, EngineOptions& o) {
  a("rate", o.sample_rate, kSampleRates);
  a("block", o.block, kBlocks);
  a("channels", o.channels, kChannelCounts);
  a("scene", o.scene);
  a("mix", o.mix);
  a("boom", o.booms);
}

/// Throws InvalidField for the first option out of its range or at odds with another. Thread: OFF.
void require_valid(const EngineOptions& options);

}  // namespace rigsound
