// When the hammer strikes and how hard: one train per boom, heard by the drill and the tool layer alike.
#pragma once

#include <array>
#include <cstdint>

#include "rigsound/click_bank.hpp"
#include "rigsound/dsp/random.hpp"
#include "rigsound/impact.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/machine/machine_state.hpp"

namespace rigsound::impact {

/// How blows are spaced and weighed (drilling paper, section 3.7; gaps and amplitudes are lognormal
/// AR(1) series, so that neither can turn negative).
struct Statistics {
  double mean_gap_samples = 0;       ///< T_0: mean gap; 0: no impacts
  double gap_variation = 0;          ///< sigma_T / T_0
  double gap_correlation = 0;        ///< lag-1 correlation of gaps
  double miss_share = 0;             ///< share of doubled gaps
  double double_share = 0;           ///< share of short gaps
  double amplitude_variation = 0;    ///< sigma_B / B
  double amplitude_correlation = 0;  ///< lag-1 correlation of amplitudes
  double snap = 0;                   ///< amplitude of one impact more, at once (a rod breaks); 0: none
};

/// The statistics of `bank` under the live controls. `rate_hz` > 0 (the machine's) replaces the bank's
/// own rate, the control's mean frequency replaces both. Thread: RT.
Statistics statistics_of(const ClickBank& bank, double sample_rate, double rate_hz,
                         const DrillControls& controls) noexcept;

/// Mixture of two statistics: the mean gap geometrically, the rest linearly. `share` 0...1 is b's. Thread:
/// RT.
Statistics blend(const Statistics& a, const Statistics& b, double share) noexcept;

class ImpactTrain {
 public:
  ImpactTrain(std::uint64_t seed, int boom) noexcept;

  /// Blows that start within the next kChunk samples. Without a mean gap the hammer rests, and strikes at
  /// once when it comes back. Thread: RT.
  void process(const Statistics& statistics) noexcept;

  Impacts impacts() const noexcept { return {impacts_.data(), count_}; }

 private:
  double draw_gap(const Statistics& s) noexcept;
  double draw_amplitude(const Statistics& s) noexcept;

  dsp::RandomField random_;
  std::array<Impact, kMaxImpacts> impacts_{};
  int count_ = 0;
  double waited_ = 0;        ///< mean gaps that have passed since the last blow
  double gap_ = 0;           ///< the gap to the next blow, in mean gaps
  double after_double_ = 0;  ///< what is left of a gap after its double strike, in mean gaps; 0: none
  double z_gap_ = 0, z_amplitude_ = 0;  ///< AR(1) states
  std::uint64_t index_ = 0;
};

}  // namespace rigsound::impact
