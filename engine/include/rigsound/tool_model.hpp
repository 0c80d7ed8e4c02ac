// The steel that rings: its geometry, how it is struck, how it sounds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/tool_design.hpp"

namespace rigsound {

enum class ToolKind : std::uint8_t {
  kDesigned,  ///< allpass sections designed so that the loop's poles are the bar's modes
  kPaper,     ///< the paper's own structure: M identical first-order allpass sections, whole delays
};

/// One strike (paper, section 3.3). Random shares are of the mean, drawn anew for every strike.
struct Strike {
  double width_s = 10 / 44100.0;            ///< Hann pulse, s; the paper's 7...11 samples are 181...272 us
  double amplitude_variation = 0.2;         ///< +- share of the amplitude, 0...1
  int bounces = 3;                          ///< 0...kMaxBounces, each after the one before
  double gap_min = 0.05, gap_max = 0.10;    ///< share of the period between them
  double ratio_min = 0.3, ratio_max = 0.7;  ///< amplitude against the one before
  double fall_s = 0.002, rise_s = 0.010;    ///< k_T from k_max to k_min and back
  double slope_variation = 0.3;             ///< +- share of both slopes, 0...0.9
};

/// One bell of the tool's equaliser, after the high-pass.
struct ToolBand {
  double frequency_hz = 1000, gain_db = 0, q = 1.4;
};

struct ToolVoicing {
  double transversal_mix = 0.5, longitudinal_mix = 0.5;  ///< linear weights of the two families
  double highpass_hz = 800;         ///< -6.02 dB point of the first-order high-pass (section 3)
  std::vector<ToolBand> equaliser;  ///< at most kMaxToolBands
  double level = 0.2;               ///< linear, of everything
};

/// Another steel that rings instead while this many rods are on the string.
struct RodSteel {
  int rods = 2;  ///< 1...20
  Bar bar;
};

/// The paper's own loops, for ToolKind::kPaper.
struct PaperLoops {
  int M = 40;              ///< cascade length (eq. 5), 1...kMaxPaperSections
  double lambda = -0.618;  ///< eq. 4, -1 < lambda < 0
  int N_T = 50;            ///< transversal delay line, samples
  int N_L = 8;             ///< longitudinal delay line, samples
};

/// Everything a tool file says. design_tool() checks it.
struct ToolModel {
  std::string name;
  ToolKind kind = ToolKind::kDesigned;
  Bar bar;
  Decay transversal;
  Decay longitudinal{0.94, 0.94, 0.8, 6000, {}};
  Strike strike;
  ToolVoicing voicing;
  PaperLoops paper;
  std::vector<RodSteel> rods;       ///< at most 20; other rod counts ring with `bar`
  std::vector<ToolDesign> designs;  ///< made ahead of time, at most one a sample rate
};

}  // namespace rigsound
