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

constexpr Word<ToolKind> kToolKinds[] = {{"designed", ToolKind::kDesigned}, {"paper", ToolKind::kPaper}};

/// One strike (paper, section 3.3). Random shares are of the mean, drawn anew for every strike.
struct Strike {
  double width_s = 10 / 44100.0;            ///< Hann pulse, s; the paper's 7 to 11 samples are 181 to 272 us
  double amplitude_variation = 0.2;         ///< +- share of the amplitude
  int bounces = 3;                          ///< each after the one before
  double gap_min = 0.05, gap_max = 0.10;    ///< share of the period between them
  double ratio_min = 0.3, ratio_max = 0.7;  ///< amplitude against the one before
  double fall_s = 0.002, rise_s = 0.010;    ///< k_T from k_max to k_min and back
  double slope_variation = 0.3;             ///< +- share of both slopes
};

template <class Archive>
void fields(Archive& a, Strike& o) {
  constexpr Range kGaps{0.01, 0.2}, kRatios{0, 1}, kSlopes{1e-4, 1, "s"};
  a("width_s", o.width_s, Range{20e-6, 5e-3, "s"});
  a("amplitude_variation", o.amplitude_variation, Range{0, 1});
  a("bounces", o.bounces, Range{0, kMaxBounces});
  a("gap_min", o.gap_min, kGaps);
  a("gap_max", o.gap_max, kGaps);
  a("ratio_min", o.ratio_min, kRatios);
  a("ratio_max", o.ratio_max, kRatios);
  a("fall_s", o.fall_s, kSlopes);
  a("rise_s", o.rise_s, kSlopes);
  a("slope_variation", o.slope_variation, Range{0, 0.9});
}

/// One bell of the tool's equaliser, after the high-pass, at most at kHighestCorner of the sample rate.
struct ToolBand {
  double frequency_hz = 1000, gain_db = 0, q = 1.4;
};

template <class Archive>
void fields(Archive& a, ToolBand& o) {
  a("frequency_hz", o.frequency_hz, Range{20, kHighestCorner * kMaxSampleRate, "Hz"});
  a("gain_db", o.gain_db, Range{-36, 36, "dB"});
  a("q", o.q, Range{0.1, 20});
}

struct ToolVoicing {
  double transversal_mix = 0.5, longitudinal_mix = 0.5;  ///< linear weights of the two families
  double highpass_hz = 800;         ///< -6.02 dB point of the first-order high-pass (section 3)
  std::vector<ToolBand> equaliser;  ///< at most kMaxToolBands
  double level = 0.2;               ///< linear, of everything
};

template <class Archive>
void fields(Archive& a, ToolVoicing& o) {
  constexpr Range kWeights{0, 10};
  a("mix_T", o.transversal_mix, kWeights);
  a("mix_L", o.longitudinal_mix, kWeights);
  a("highpass_hz", o.highpass_hz, Range{10, 8000, "Hz"});
  a("level", o.level, kWeights);
  a("equaliser", o.equaliser);
}

/// Another steel that rings instead while this many rods are on the string.
struct RodSteel {
  int rods = 2;
  Bar bar;
};

template <class Archive>
void fields(Archive& a, RodSteel& o) {
  a("rods", o.rods, Range{1, kMaxRodSteels});
  fields(a, o.bar);
}

/// The paper's own loops, for ToolKind::kPaper.
struct PaperLoops {
  int M = 40;              ///< cascade length (eq. 5)
  double lambda = -0.618;  ///< eq. 4
  int N_T = 50;            ///< transversal delay line, samples
  int N_L = 8;             ///< longitudinal delay line, samples
};

template <class Archive>
void fields(Archive& a, PaperLoops& o) {
  constexpr Range kDelays{1, kMaxLoopDelay, "samples"};
  a("M", o.M, Range{1, kMaxPaperSections});
  a("lambda", o.lambda, Range{-0.999, -0.001});
  a("N_T", o.N_T, kDelays);
  a("N_L", o.N_L, kDelays);
}

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
  std::vector<RodSteel> rods;       ///< at most kMaxRodSteels; other rod counts ring with `bar`
  std::vector<ToolDesign> designs;  ///< made ahead of time, at most one a sample rate
};

template <class Archive>
void fields(Archive& a, ToolModel& o) {
  a("model", o.kind, kToolKinds);
  fields(a, o.bar);
  a("transversal", o.transversal);
  a("longitudinal", o.longitudinal);
  a("strike", o.strike);
  a("voicing", o.voicing);
  a("paper", o.paper);
  a("rods", o.rods);
  a("designs", o.designs);
}

}  // namespace rigsound
