#include "timeline/level_picture.hpp"

#include <algorithm>
#include <cmath>

#include "chart/spectrum_palette.hpp"
#include "spectrum/window_power.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kWindow = 4096, kHop = 1024, kMostFramesInColumn = 8, kColours = 256;
constexpr double kSilence_db = -200, kHighest_hz = 20000;

/// Windows spread evenly over samples [from, to); what lies outside the sound is silence.
void add_windows(const std::vector<float>& x, double from, double to, WindowPower& spectrum) {
  spectrum.clear();
  const int frames = std::clamp(static_cast<int>((to - from) / kHop), 1, kMostFramesInColumn);
  std::vector<float> window(kWindow);
  for (int f = 0; f < frames; ++f) {
    const long start = std::lround(from + (to - from) * (f + 0.5) / frames) - kWindow / 2;
    for (long n = 0; n < kWindow; ++n) {
      const long at = start + n;
      window[n] = at >= 0 && at < static_cast<long>(x.size()) ? x[at] : 0;
    }
    spectrum.add(window.data(), 1.0 / frames);
  }
}

/// A little over nearly everything, a multiple of 5 dB.
double top_of(std::vector<float> levels) {
  constexpr double kBelow = 0.999, kStep_db = 5;
  const auto place = levels.begin() + static_cast<long>(kBelow * static_cast<double>(levels.size() - 1));
  std::nth_element(levels.begin(), place, levels.end());
  return std::max(kStep_db * std::ceil(static_cast<double>(*place) / kStep_db), kSilence_db + kLevelRange_db);
}

}  // namespace

LevelPicture level_picture(const SoundFile& sound, int width, int height) {
  const double highest_hz = std::min(kHighest_hz, 0.5 * sound.rate),
               bin_hz = static_cast<double>(sound.rate) / kWindow;
  std::vector<double> edges;  // of the rows, in bins
  for (int row = 0; row <= height; ++row)
    edges.push_back(kLowestLevel_hz *
                    std::pow(highest_hz / kLowestLevel_hz, static_cast<double>(row) / height) / bin_hz);
  WindowPower spectrum(kWindow);
  std::vector<float> levels(static_cast<std::size_t>(width) * height);
  const double column = static_cast<double>(sound.mono.size()) / width;
  for (int x = 0; x < width; ++x) {
    add_windows(sound.mono, x * column, (x + 1) * column, spectrum);
    for (int row = 0; row < height; ++row)
      levels[static_cast<std::size_t>(height - 1 - row) * width + x] = static_cast<float>(
          std::max(kSilence_db, 10 * std::log10(spectrum.between(edges[row], edges[row + 1]) + 1e-30)));
  }
  LevelPicture shown{{width, {}, chart::smooth_spectrum_palette(kColours)}, top_of(levels), highest_hz};
  for (const float level : levels)
    shown.picture.pixels.push_back(static_cast<std::uint8_t>(
        std::clamp((kColours - 1) * (1 + (static_cast<double>(level) - shown.top_db) / kLevelRange_db), 0.0,
                   kColours - 1.0)));
  return shown;
}

}  // namespace rigsound::analysis
