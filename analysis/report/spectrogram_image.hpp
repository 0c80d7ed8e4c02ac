// A spectrogram as a picture, frequency on a log scale.
#pragma once

#include <string>
#include <vector>

namespace rigsound::analysis {

constexpr double kSpectrogramLowHz = 80, kSpectrogramHighHz = 18000;

/// Loudest band power of any column, for use as `reference` of pictures that are compared. Thread: OFF.
double spectrogram_peak(const std::vector<float>& x);

/// PNG data URI; 64 dB from black to white, white at `reference`. Thread: OFF.
std::string spectrogram_image(const std::vector<float>& x, double reference);

}  // namespace rigsound::analysis
