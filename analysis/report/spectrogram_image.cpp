#include "report/spectrogram_image.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "chart/spectrum_palette.hpp"
#include "rigsound/analysis/rate.hpp"
#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kRows = 60, kMaxColumns = 600;
constexpr StftShape kShape{768, 128,
                           1024};  // clicks at 60 Hz stay apart, orders of the diesel do so above 100 Hz

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

chart::Picture spectrogram_image(const std::vector<float>& x, double reference) {
  const Eigen::ArrayXXd bands = band_powers(x);
  std::vector<std::uint8_t> pixels;
  for (long row = kRows; row-- > 0;)
    for (long c = 0; c < bands.cols(); ++c) {
      const double db = 10 * std::log10(std::max(bands(row, c), 1e-30) / std::max(reference, 1e-30));
      pixels.push_back(static_cast<std::uint8_t>(std::clamp(15 * (1 + db / kSpectrogramRangeDb), 0.0, 15.0)));
    }
  return {static_cast<int>(bands.cols()),
          std::move(pixels),
          {chart::kSpectrumPalette.begin(), chart::kSpectrumPalette.end()}};
}

}  // namespace rigsound::analysis
