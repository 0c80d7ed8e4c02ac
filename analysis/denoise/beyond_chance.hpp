// What a blind split explains beyond what its free activations explain of any noise.
#pragma once

#include "denoise/factors.hpp"

namespace rigsound::analysis {

/// mean_psd() of a blind split, where S counts as far as its bin needs it: times the share of the bin's gain
/// of likelihood over `background` (the divergence a slow background alone leaves, bins x frames) that chance
/// does not give, the rest added to N. Every activation is free and fits noise by about a nat, to which all
/// bins come up alike. Where few bins hold the drilling, the hiss of all others is taken for it without this.
/// Thread: OFF.
MeanPsd psd_beyond_chance(const Factors& blind, const PowerSpectrogram& power, const Grid& background);

}  // namespace rigsound::analysis
