#include "engine/hostile/hostile_run.hpp"

#include <cmath>
#include <vector>

#include "engine/allocation_guard.hpp"
#include "engine/mix/true_peak_meter.hpp"

namespace rigsound::tests {
namespace {

constexpr int kLongestHold = 400;  // blocks
constexpr double kHealing_s = 0.05, kSane_s = 1;

/// An engine, and what its blocks are held against.
class Player {
 public:
  Player(const EngineOptions& options, SoundSet sounds, HostileFindings& findings)
      : engine_(options, std::move(sounds)),
        block_(static_cast<std::size_t>(options.block * options.channels)),
        ceiling_(std::pow(10.0, options.mix.ceiling_dbfs / 20)),
        findings_(findings) {}

  void play(const MachineState& state) {
    const long before = allocations();
    engine_.process(state, block_.data());
    findings_.allocations += allocations() - before;
    ++findings_.blocks;
    const auto channels = static_cast<std::size_t>(engine_.options().channels);
    for (std::size_t i = 0; i < block_.size(); ++i) {
      const auto x = static_cast<double>(block_[i]);
      findings_.not_finite += std::isfinite(x) ? 0 : 1;
      findings_.over_ceiling += std::fabs(x) > ceiling_ * (1 + 1e-7) ? 1 : 0;
      if (i % channels < 2) meter_[i % channels].add(x);
    }
    if (lookahead_frames(engine_.options()) == 0) return;
    for (const TruePeakMeter& meter : meter_)
      findings_.highest_true_peak = std::max(findings_.highest_true_peak, meter.peak() / ceiling_);
  }

  /// So many seconds of `state`; returns the highest peak.
  float play_for(const MachineState& state, double seconds) {
    float peak = 0;
    const double blocks = seconds * engine_.options().sample_rate / engine_.options().block;
    for (int i = 0; i < blocks; ++i) play(state), peak = std::max(peak, engine_.meters().peak);
    return peak;
  }

  std::int64_t dropped() const { return static_cast<std::int64_t>(engine_.meters().dropped_chunks); }

 private:
  Engine engine_;
  std::vector<float> block_;
  double ceiling_;
  TruePeakMeter meter_[2];  ///< of the channels that sound
  HostileFindings& findings_;
};

MachineState sane_state() {
  MachineState state;
  state.engine_rpm = 1500;
  for (BoomState& boom : state.boom) {
    boom.feed_pressure_bar = 90;
    boom.percussion = Percussion::kOn;
    boom.percussion_rate_hz = 40;
  }
  return state;
}

}  // namespace

void run_hostile(HostileInput& input, std::int64_t blocks, HostileFindings& findings) {
  const EngineOptions options = input.options();
  Player player(options, input.sounds(options.sample_rate), findings);
  ++findings.engines;
  MachineState state;
  for (std::int64_t block = 0, next = 0; block < blocks; ++block) {
    if (block == next) {
      state = input.state();
      next += input.below(2) == 0 ? 1 : 1 + input.below(kLongestHold);
    }
    player.play(state);
  }
  player.play_for(sane_state(), kHealing_s);
  const std::int64_t dropped = player.dropped();
  const bool sounds = player.play_for(sane_state(), kSane_s) > 0;
  findings.not_healed += sounds && player.dropped() == dropped ? 0 : 1;
  findings.dropped_chunks += player.dropped();
}

}  // namespace rigsound::tests
