// Steps 1 to 6 on one clip of a few seconds, by either method.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "chain/clip_verdict.hpp"
#include "chain/dump.hpp"
#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

/// The chain on a clip short enough to be stationary (up to about 4 s); the verdict is asked for `windows` of
/// it. One result a machine, whose background is all the rest; one where there is none. Thread: OFF.
std::vector<ChainResult> analyse_clip(const std::vector<float>& mono, const std::vector<Segment>& windows,
                                      const ChainOptions& options);

/// What a method finds of one machine in a normalised clip: all in the units of the clip (RMS 1).
struct ClipMachine {
  std::vector<JudgedWindow> verdict;
  ClickTrain clicks;                     ///< amplitudes in the whitened signal
  std::vector<float> drilling;           ///< as long as the clip
  Eigen::ArrayXd signal_psd, noise_psd;  ///< mean power per bin of kChainStft
};

/// Steps 1 to 6 of the click-synchronous method: one machine, or two that both drill. Thread: OFF.
std::vector<ClipMachine> split_by_click_nmf(const std::vector<float>& x, const std::vector<Segment>& windows,
                                            const ChainOptions& options, const Dump& dump);

/// Sections 2 and 3.1 to 3.5 of the drilling paper, which knows one machine. Thread: OFF.
ClipMachine split_by_paper(const std::vector<float>& x, const std::vector<Segment>& windows,
                           const ChainOptions& options, const Dump& dump);

}  // namespace rigsound::analysis
