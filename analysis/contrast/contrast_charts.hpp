// The charts of the contrast page, SVG elements each. Thread: OFF.
#pragma once

#include <string>

#include "rigsound/analysis/contrast.hpp"

namespace rigsound::analysis {

/// Share told right over the feed, the fitted curves, where three quarters are told, and how sure that is.
std::string heard_chart(const Contrast& contrast);
/// Third-octave distance from normal, and that of two runs of normal.
std::string distance_chart(const Contrast& contrast);
std::string loudness_chart(const Contrast& contrast);
std::string rate_chart(const Contrast& contrast);

}  // namespace rigsound::analysis
