// A spectrogram as an image, frequency on a log scale.
#pragma once

#include <vector>

#include "chart/canvas.hpp"

namespace rigsound::analysis {

constexpr double kSpectrogramLowHz = 80, kSpectrogramHighHz = 18000;
constexpr double kSpectrogramRangeDb = 56;

/// Loudest band power of any column, for use as `reference` of images that are compared. Thread: OFF.
double spectrogram_peak(const std::vector<float>& x);

/// kSpectrogramRangeDb over the palette, its last colour at `reference`. Thread: OFF.
chart::Picture spectrogram_image(const std::vector<float>& x, double reference);

}  // namespace rigsound::analysis
