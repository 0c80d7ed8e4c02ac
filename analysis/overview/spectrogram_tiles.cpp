#include <algorithm>
#include <cmath>

#include "chart/picture_png.hpp"
#include "chart/spectrum_palette.hpp"
#include "report/spectrogram_image.hpp"
#include "rigsound/analysis/overview.hpp"
#include "spectrum/window_power.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kTileRows = 256, kMostWindowsOfColumn = 4;
constexpr long kReadAtOnce = 8L << 20;  // frames

/// Edges of the rows from the bottom, in bins.
std::vector<double> row_edges(int rate, int window) {
  std::vector<double> edges;
  for (int row = 0; row <= kTileRows; ++row)
    edges.push_back(kSpectrogramLowHz *
                    std::pow(kSpectrogramHighHz / kSpectrogramLowHz, static_cast<double>(row) / kTileRows) *
                    window / rate);
  return edges;
}

/// 0 above half the sampling rate.
double row_power(const WindowPower& spectrum, const std::vector<double>& edges, int row) {
  if (edges[row] >= static_cast<double>(spectrum.power().size() - 1)) return 0;
  return spectrum.between(edges[row], edges[row + 1]);
}

/// The samples of a tile: read at once where they are few, window by window where they are many.
class TileSamples {
 public:
  TileSamples(SoundReader& sound, const TilePlace& place, int window)
      : sound_(sound), from_(place.first_frame() - window), window_(window) {
    const long frames = kTileColumns * place.column_frames() + 2L * window;
    if (frames <= kReadAtOnce) all_ = sound.read(from_, static_cast<std::size_t>(frames));
  }

  /// The window around a frame.
  const float* around(long frame) {
    const long start = frame - window_ / 2;
    if (!all_.empty()) return &all_[static_cast<std::size_t>(start - from_)];
    one_.resize(static_cast<std::size_t>(window_));
    sound_.read(start, one_.size(), one_.data());
    return one_.data();
  }

 private:
  SoundReader& sound_;
  long from_;
  int window_;
  std::vector<float> all_, one_;
};

std::uint8_t colour_of(double power, double loudest) {
  const double db = 10 * std::log10(std::max(power, 1e-30) / std::max(loudest, 1e-30));
  return static_cast<std::uint8_t>(std::clamp(15 * (1 + db / kSpectrogramRangeDb), 0.0, 15.0));
}

}  // namespace

double loudest_power(SoundReader& sound) {
  constexpr int kWindows = 1024;
  WindowPower spectrum(short_window(sound.shape().rate));
  const std::vector<double> edges = row_edges(sound.shape().rate, spectrum.length());
  std::vector<float> x(static_cast<std::size_t>(spectrum.length()));
  double loudest = 0;
  for (int w = 0; w < kWindows; ++w) {
    sound.read(sound.shape().frames * w / kWindows, x.size(), x.data());
    spectrum.clear();
    spectrum.add(x.data(), 1);
    for (int row = 0; row < kTileRows; ++row) loudest = std::max(loudest, row_power(spectrum, edges, row));
  }
  return loudest;
}

std::string spectrogram_tile(SoundReader& sound, const TilePlace& place, double loudest) {
  WindowPower spectrum(short_window(sound.shape().rate));
  const std::vector<double> edges = row_edges(sound.shape().rate, spectrum.length());
  TileSamples samples(sound, place, spectrum.length());
  const long wide = place.column_frames();
  const int windows =
      static_cast<int>(std::clamp<long>(wide / (spectrum.length() / 2), 1, kMostWindowsOfColumn));
  chart::Picture picture{kTileColumns,
                         std::vector<std::uint8_t>(static_cast<std::size_t>(kTileColumns) * kTileRows, 0),
                         {chart::kSpectrumPalette.begin(), chart::kSpectrumPalette.end()}};
  for (int c = 0; c < kTileColumns && place.first_frame() + c * wide < sound.shape().frames; ++c) {
    spectrum.clear();
    for (int w = 0; w < windows; ++w)
      spectrum.add(samples.around(place.first_frame() + c * wide + wide * (2 * w + 1) / (2 * windows)),
                   1.0 / windows);
    for (int row = 0; row < kTileRows; ++row)
      picture.pixels[static_cast<std::size_t>(kTileRows - 1 - row) * kTileColumns + c] =
          colour_of(row_power(spectrum, edges, row), loudest);
  }
  return chart::png_bytes(picture);
}

}  // namespace rigsound::analysis
