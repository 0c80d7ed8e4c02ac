// A spectrogram as an image, frequency on a log scale.
#pragma once

#include <array>
#include <vector>

#include "chart/canvas.hpp"

namespace rigsound::analysis {

constexpr double kSpectrogramLowHz = 80, kSpectrogramHighHz = 18000;
constexpr double kSpectrogramRangeDb = 56;

// Dark violet over red and orange to pale yellow: even steps of lightness, so it prints in grey too.
constexpr std::array<chart::Colour, 16> kSpectrogramPalette = {{{0, 0, 4},
                                                                {12, 8, 38},
                                                                {31, 12, 72},
                                                                {54, 9, 94},
                                                                {78, 13, 108},
                                                                {101, 21, 110},
                                                                {125, 30, 109},
                                                                {147, 38, 103},
                                                                {170, 46, 93},
                                                                {190, 57, 80},
                                                                {209, 70, 65},
                                                                {226, 88, 48},
                                                                {239, 110, 30},
                                                                {248, 138, 12},
                                                                {251, 175, 40},
                                                                {252, 246, 164}}};

/// Loudest band power of any column, for use as `reference` of images that are compared. Thread: OFF.
double spectrogram_peak(const std::vector<float>& x);

/// kSpectrogramRangeDb over the palette, its last colour at `reference`. Thread: OFF.
chart::Picture spectrogram_image(const std::vector<float>& x, double reference);

}  // namespace rigsound::analysis
