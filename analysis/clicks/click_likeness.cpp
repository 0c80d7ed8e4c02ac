#include "clicks/click_likeness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "clicks/rhythm.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kBands = 19;  // the lowest from the first bin to kSecond_hz, the others as wide in octaves
constexpr double kSecond_hz = 250, kHighest_hz = 16000;
constexpr double kAudible = 1e-6;  // of the loudest band
constexpr long kBeforeFrames = 2;
constexpr double kFloorQuantile = 0.1;
constexpr int kSweeps = 60;
constexpr double kLeastRise = -1, kMostRise = 3;  // nepers of power: one silent band is not all

/// Mean power a bin, bands x frames, of the bands that hold anything and lie below bin `end`.
Eigen::ArrayXXd band_powers(const PowerSpectrogram& power, long end) {
  Eigen::ArrayXXd bands(kBands, power.frames);
  const double bin_hz = kAnalysisRate / kChainStft.fft;
  const auto edge = [&](int band) {
    const double octaves = std::log2(kHighest_hz / kSecond_hz) * (band - 1) / (kBands - 1);
    return band == 0 ? 1L : static_cast<long>(std::ceil(kSecond_hz * std::exp2(octaves) / bin_hz));
  };
  int whole = 1;
  while (whole < kBands && edge(whole + 1) <= end) ++whole;
  for (int band = 0; band < whole; ++band)
    bands.row(band) = power.P.leftCols(power.frames)
                          .middleRows(edge(band), edge(band + 1) - edge(band))
                          .cast<double>()
                          .colwise()
                          .mean();
  const Eigen::ArrayXd mean = bands.topRows(whole).rowwise().mean();
  long audible = 0;
  for (int band = 0; band < whole; ++band)
    if (mean(band) > kAudible * mean.maxCoeff()) bands.row(audible++) = bands.row(band).eval();
  return bands.topRows(audible);
}

/// What a band's mean over `length` frames is when it is quiet.
Eigen::ArrayXd quiet_powers(const Eigen::ArrayXXd& bands, long length) {
  Eigen::ArrayXd quiet(bands.rows());
  for (long band = 0; band < bands.rows(); ++band) {
    std::vector<double> means;
    for (long frame = 0; frame + length <= bands.cols(); ++frame)
      means.push_back(bands.row(band).segment(frame, length).mean());
    quiet(band) = quantile(std::move(means), kFloorQuantile);
  }
  return quiet;
}

/// E, bands x clicks, as quiet + spectrum gain', by multiplicative updates: the mean divergence that is left.
double dispersion(const Eigen::ArrayXXd& E, const Eigen::ArrayXd& quiet) {
  Eigen::ArrayXd spectrum = (E.rowwise().mean() - quiet).max(1e-3 * quiet);
  Eigen::ArrayXd gain = Eigen::ArrayXd::Ones(E.cols());
  Eigen::ArrayXXd M;
  const auto model = [&] { M = (spectrum.matrix() * gain.matrix().transpose()).array().colwise() + quiet; };
  model();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    gain *= ((E / M.square()).matrix().transpose() * spectrum.matrix()).array().sqrt() /
            (M.inverse().matrix().transpose() * spectrum.matrix()).array().sqrt();
    model();
    spectrum *= ((E / M.square()).matrix() * gain.matrix()).array().sqrt() /
                (M.inverse().matrix() * gain.matrix()).array().sqrt();
    model();
  }
  const Eigen::ArrayXXd ratio = E / M;
  return (ratio - ratio.log() - 1).mean();
}

}  // namespace

ClickLikeness click_likeness(const PowerSpectrogram& power, const ClickFrames& clicks, long heard) {
  const std::vector<long>& onset = clicks.onset;
  if (onset.size() < 2) return {};
  const Eigen::ArrayXXd bands = band_powers(power, heard);
  Eigen::ArrayXXd after(bands.rows(), onset.size()), before(bands.rows(), onset.size());
  for (long i = 0; i < after.cols(); ++i) {
    after.col(i) = bands.middleCols(onset[i], clicks.length).rowwise().mean();
    before.col(i) = bands.middleCols(onset[i] - kBeforeFrom, kBeforeFrames).rowwise().mean();
  }
  return {dispersion(after, quiet_powers(bands, clicks.length)),
          (after / before).log().max(kLeastRise).min(kMostRise).mean(), rhythm(after.log(), onset)};
}

}  // namespace rigsound::analysis
