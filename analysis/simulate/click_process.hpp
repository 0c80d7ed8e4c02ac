// When a simulated drill makes an impact, and how strong it is: the truth the analysis has to find again.
#pragma once

#include <optional>
#include <vector>

#include "simulate/split_mix.hpp"

namespace rigsound::analysis {

enum class ClickKind { kImpact = 0, kDouble = 1, kBounce = 2 };

struct SimulatedClick {
  int P = 0;        ///< onset, samples at 48 kHz
  double beta = 1;  ///< amplitude, 1 = mean impact
  ClickKind kind = ClickKind::kImpact;
};

/// After every impact the steel makes contact a second time, softer: delay in periods, amplitude relative.
struct Bounce {
  double delay_low, delay_high, strength_low, strength_high;
};

struct ClickProcess {
  double F0 = 40;            ///< impacts a second, Hz
  double jitter = 0;         ///< standard deviation of a gap, periods
  double amplitude_cv = 0;   ///< standard deviation of the amplitudes over their mean
  double amplitude_rho = 0;  ///< lag-1 correlation of the amplitudes
  bool metronome = false;    ///< jitter around a fixed grid instead of gap after gap
  double miss = 0;           ///< share of impacts that do not come
  double twice = 0;          ///< share of impacts followed by a double impact
  std::optional<Bounce> bounce;

  double T0() const;  ///< period, samples
};

/// Clicks in [0, seconds), ascending. The number and order of the draws depend only on F0, seconds and
/// the share of missed impacts, so ids keep their sound. Thread: OFF.
std::vector<SimulatedClick> draw_clicks(const ClickProcess& process, double seconds, SplitMix& stream);

}  // namespace rigsound::analysis
