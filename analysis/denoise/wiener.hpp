// From modelled powers to the drilling's samples.
#pragma once

#include "denoise/power.hpp"

namespace rigsound::analysis {

/// G X with the Wiener gain G = S / (S + N). Thread: OFF.
Spectrogram wiener(const Spectrogram& X, const PsdPair& psd);

}  // namespace rigsound::analysis
