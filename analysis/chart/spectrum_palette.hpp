// The colours of spectrograms.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "chart/paint.hpp"

namespace rigsound::chart {

// Dark violet over red and orange to pale yellow: even steps of lightness, so it prints in grey too.
constexpr std::array<Colour, 16> kSpectrumPalette = {{{0, 0, 4},
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

/// The same colours in `count` smooth steps. Thread: OFF.
inline std::vector<Colour> smooth_spectrum_palette(int count) {
  std::vector<Colour> colours;
  for (int i = 0; i < count; ++i) {
    const double place = static_cast<double>(i) * (kSpectrumPalette.size() - 1) / (count - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kSpectrumPalette.size() - 2);
    const Colour a = kSpectrumPalette[below], b = kSpectrumPalette[below + 1];
    const auto mix = [share = place - static_cast<double>(below)](std::uint8_t from, std::uint8_t to) {
      return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
    };
    colours.push_back({mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)});
  }
  return colours;
}

}  // namespace rigsound::chart
