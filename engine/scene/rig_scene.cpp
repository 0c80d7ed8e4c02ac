#include "scene/rig_scene.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::scene {
namespace {

// Load and hydraulic pressure act on the sound with this time constant, the master gain with the other.
constexpr double kLoad_s = 0.15;
constexpr double kGain_s = 0.02;

// A diesel that only idles and one that feeds and hammers at full pressure, when no bus says its load.
constexpr double kFeedShare = 0.5, kHammerShare = 0.4;

}  // namespace

RigScene::RigScene(const EngineOptions& options) noexcept
    : chunk_s_(kChunk / options.sample_rate),
      overfeed_bar_(options.scene.overfeed_bar),
      load_smoothing_(dsp::one_pole_remainder(kLoad_s, kChunk, options.sample_rate)),
      gain_smoothing_(dsp::one_pole_remainder(kGain_s, kChunk, options.sample_rate)) {}

void RigScene::set(const MachineState& state, int booms, int hammering) noexcept {
  double feed = 0;
  for (int b = 0; b < booms; ++b)
    feed = std::max(feed, static_cast<double>(state.boom[static_cast<std::size_t>(b)].feed_pressure_bar));
  feed_ = std::min(1.0, feed / overfeed_bar_);
  load_ = state.engine_load >= 0 ? static_cast<double>(state.engine_load)
                                 : kFeedShare * feed_ + (hammering > 0 ? kHammerShare : 0.0);
  const SpeedTrend speed{static_cast<double>(state.engine_rpm), static_cast<double>(state.engine_rpm_slope)};
  if (speed.rpm != speed_.rpm || speed.slope != speed_.slope) speed_ = speed, speed_age_s_ = 0;
  paused_ = state.simulation != Simulation::kRun;
  wanted_gain_ = paused_ ? 0.0
                         : dsp::gain_of_db(static_cast<double>(state.master_gain_db)) *
                               static_cast<double>(state.output_gain);
}

void RigScene::advance() noexcept {
  speed_age_s_ += chunk_s_;
  diesel_.rpm = speed_.at(speed_age_s_);
  diesel_.load = dsp::approached(diesel_.load, load_, load_smoothing_);
  diesel_.feed = dsp::approached(diesel_.feed, feed_, load_smoothing_);
  gain_.go_to(dsp::approached(gain_.to, wanted_gain_, gain_smoothing_));
  // An exponential never arrives; a muted rig has to be silent, not nearly so, and one at full level needs no
  // scaling by what rounding leaves of the way.
  if (std::fabs(gain_.to - wanted_gain_) < (wanted_gain_ == 0 ? 1e-6 : 1e-14 * wanted_gain_))
    gain_.to = wanted_gain_;
}

}  // namespace rigsound::scene
