#include "report/spectrogram_image.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "denoise/stft.hpp"
#include "report/indexed_png.hpp"
#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kRows = 72, kMaxColumns = 360;
constexpr double kRangeDb = 64;
constexpr StftShape kShape{1024, 256, 1024};

// Dark violet over red and orange to pale yellow: even steps of lightness, so it prints in grey too.
constexpr std::array<Colour, 16> kPalette = {{{0, 0, 4},
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

/// kRows log-spaced bands by at most kMaxColumns columns, mean power.
Eigen::ArrayXXd band_powers(const std::vector<float>& x) {
  const Eigen::ArrayXXd power = stft(x, kShape).abs2().cast<double>();
  const long columns = std::min<long>(kMaxColumns, power.cols());
  Eigen::ArrayXXd bands(kRows, columns);
  const double ratio = std::pow(kSpectrogramHighHz / kSpectrogramLowHz, 1.0 / kRows),
               step = kAnalysisRate / kShape.fft;
  for (long row = 0; row < kRows; ++row) {
    const double low = kSpectrogramLowHz * std::pow(ratio, row);
    const auto first = std::lround(low / step), count = std::max(1L, std::lround(low * ratio / step) - first);
    const Eigen::ArrayXd course = power.middleRows(first, count).colwise().mean().transpose();
    for (long c = 0; c < columns; ++c) {
      const long from = power.cols() * c / columns, to = power.cols() * (c + 1) / columns;
      bands(row, c) = course.segment(from, to - from).mean();
    }
  }
  return bands;
}

}  // namespace

double spectrogram_peak(const std::vector<float>& x) { return band_powers(x).maxCoeff(); }

std::string spectrogram_image(const std::vector<float>& x, double reference) {
  const Eigen::ArrayXXd bands = band_powers(x);
  std::vector<std::uint8_t> pixels;
  for (long row = kRows; row-- > 0;)
    for (long c = 0; c < bands.cols(); ++c) {
      const double db = 10 * std::log10(std::max(bands(row, c), 1e-30) / std::max(reference, 1e-30));
      pixels.push_back(static_cast<std::uint8_t>(std::clamp(15 * (1 + db / kRangeDb), 0.0, 15.0)));
    }
  return png_data_uri(pixels, static_cast<int>(bands.cols()), kPalette);
}

}  // namespace rigsound::analysis
