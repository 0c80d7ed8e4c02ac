#include "timeline/level_picture.hpp"

#include <algorithm>
#include <cmath>

#include "chart/spectrum_palette.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/fft.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kWindow = 4096, kHop = 1024, kMostFramesInColumn = 8, kColours = 256;
constexpr double kSilence_db = -200, kHighest_hz = 20000;

/// Mean power of every bin over the frames of one column of pixels.
class ColumnSpectrum {
 public:
  explicit ColumnSpectrum(const std::vector<float>& x) : x_(x), fft_(kWindow), re_(kWindow), im_(kWindow) {
    for (int n = 0; n < kWindow; ++n)
      window_.push_back(static_cast<float>(0.5 - 0.5 * std::cos(dsp::kTwoPi * (n + 0.5) / kWindow)));
  }

  const std::vector<double>& between(double from, double to) {
    power_.assign(kWindow / 2, 0);
    const int frames = std::clamp(static_cast<int>((to - from) / kHop), 1, kMostFramesInColumn);
    for (int f = 0; f < frames; ++f)
      add_frame(std::lround(from + (to - from) * (f + 0.5) / frames) - kWindow / 2, frames);
    return power_;
  }

 private:
  void add_frame(long start, int frames) {
    constexpr double kFullScale = kWindow / 4.0;  // what a sine of amplitude 1 leaves in its bin
    for (long n = 0; n < kWindow; ++n) {
      const long at = start + n;
      re_[n] = at >= 0 && at < static_cast<long>(x_.size()) ? window_[n] * x_[at] : 0;
      im_[n] = 0;
    }
    fft_.forward(re_.data(), im_.data());
    for (std::size_t k = 0; k < power_.size(); ++k) {
      const double re = static_cast<double>(re_[k]), im = static_cast<double>(im_[k]);
      power_[k] += (re * re + im * im) / (kFullScale * kFullScale * frames);
    }
  }

  const std::vector<float>& x_;
  dsp::Fft<float> fft_;
  std::vector<float> window_, re_, im_;
  std::vector<double> power_;
};

/// Mean power between two places on the axis of bins, or, where bins are wider than that, between two bins.
double power_between(const std::vector<double>& power, double from, double to) {
  const auto first = static_cast<std::size_t>(std::ceil(from)), end = static_cast<std::size_t>(std::ceil(to));
  if (end > first) {
    double sum = 0;
    for (std::size_t k = first; k < std::min(end, power.size()); ++k) sum += power[k];
    return sum / static_cast<double>(end - first);
  }
  const double middle = 0.5 * (from + to);
  const auto below = std::min(static_cast<std::size_t>(middle), power.size() - 2);
  const double share = middle - static_cast<double>(below);
  return std::pow(power[below] + 1e-20, 1 - share) * std::pow(power[below + 1] + 1e-20, share);
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
  ColumnSpectrum spectrum(sound.mono);
  std::vector<float> levels(static_cast<std::size_t>(width) * height);
  const double column = static_cast<double>(sound.mono.size()) / width;
  for (int x = 0; x < width; ++x) {
    const std::vector<double>& power = spectrum.between(x * column, (x + 1) * column);
    for (int row = 0; row < height; ++row)
      levels[static_cast<std::size_t>(height - 1 - row) * width + x] = static_cast<float>(
          std::max(kSilence_db, 10 * std::log10(power_between(power, edges[row], edges[row + 1]) + 1e-30)));
  }
  LevelPicture shown{{width, {}, chart::smooth_spectrum_palette(kColours)}, top_of(levels), highest_hz};
  for (const float level : levels)
    shown.picture.pixels.push_back(static_cast<std::uint8_t>(
        std::clamp((kColours - 1) * (1 + (static_cast<double>(level) - shown.top_db) / kLevelRange_db), 0.0,
                   kColours - 1.0)));
  return shown;
}

}  // namespace rigsound::analysis
