#include "scene/rig_scene.hpp"

#include <algorithm>

#include "dsp/elementary.hpp"

namespace rigsound::scene {
namespace {

// Load and hydraulic pressure act on the sound with this time constant, the master gain with the other.
constexpr double kLoad_s = 0.15;
constexpr double kGain_s = 0.02;

// A diesel that only idles and one that feeds and hammers at full pressure, when no bus says its load.
constexpr double kFeedShare = 0.5, kHammerShare = 0.4;

double smoothing(double time_s, double sample_rate) noexcept {
  return dsp::exp(-kChunk / (time_s * sample_rate));
}

}  // namespace

RigScene::RigScene(const EngineOptions& options) noexcept
    : overfeed_bar_(options.scene.overfeed_bar),
      load_smoothing_(smoothing(kLoad_s, options.sample_rate)),
      gain_smoothing_(smoothing(kGain_s, options.sample_rate)) {}

void RigScene::latch(const MachineState& state, int booms, int hammering) noexcept {
  double feed = 0;
  for (int b = 0; b < booms; ++b)
    feed = std::max(feed, static_cast<double>(state.boom[static_cast<std::size_t>(b)].feed_pressure_bar));
  feed_ = std::min(1.0, feed / overfeed_bar_);
  load_ = state.engine_load >= 0 ? static_cast<double>(state.engine_load)
                                 : kFeedShare * feed_ + (hammering > 0 ? kHammerShare : 0.0);
  background_.rpm = static_cast<double>(state.engine_rpm);
  gain_ = dsp::gain_of_db(static_cast<double>(state.master_gain_db)) * static_cast<double>(state.safety_gain);
}

void RigScene::advance() noexcept {
  background_.load = load_ + (background_.load - load_) * load_smoothing_;
  background_.feed = feed_ + (background_.feed - feed_) * load_smoothing_;
  gain_from_ = gain_to_;
  gain_to_ = gain_ + (gain_to_ - gain_) * gain_smoothing_;
  // An exponential never arrives; a muted rig has to be silent, not nearly so.
  if (gain_ == 0 && gain_to_ < 1e-6) gain_to_ = 0;
}

}  // namespace rigsound::scene
