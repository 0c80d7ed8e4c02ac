// Step 1 and the search through it; where the first random start finds nothing clear, the clearest of
// several.
#pragma once

#include <vector>

#include "chain/click_search.hpp"
#include "denoise/factors.hpp"
#include "denoise/word_fit.hpp"
#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

// What a chain has over chance, a click. Of 32 drills at -6 dB none was below 0.43, of 54 noises and effects
// three in four were below 0.23 and nine in ten below 0.6.
constexpr double kHopeless = 0.3, kClear = 1;

/// A blind split, and what is found through it, beyond its chance, or in one octave.
struct BlindStart {
  Factors blind;
  ClickSearch found;
};

/// Impacts deep in noise are found from some random starts and not from others, those of a narrow band only
/// without the hiss that a blind split takes along: where the first finds nothing clear, the clearest of
/// several, each as it is and beyond chance, and of the octaves in which narrow drills sound. After a
/// hopeless first one only the octaves are searched, unless a person said that it drills. `background`:
/// left_by_background() of the clip. Thread: OFF.
BlindStart clearest_start(const ChainOptions& options, const std::vector<float>& x, const WordFit& clip,
                          const Grid& background);

}  // namespace rigsound::analysis
