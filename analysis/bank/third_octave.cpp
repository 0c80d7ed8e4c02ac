#include "bank/third_octave.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "spectrum/frame_pair.hpp"

namespace rigsound::analysis {
namespace {

// Bins to either side: what a Hann window hears beyond is 40 dB below the least of them.
constexpr long kLobes = 4;
constexpr int kEnvelopeHop = 48;  // 1 ms
constexpr double kSilence = 1e-20, kNoModulation = 1e-7;

Eigen::ArrayXd hann_window(long length) {
  return 0.5 - 0.5 * (Eigen::ArrayXd::LinSpaced(length, 0, dsp::kTwoPi)).cos();
}

/// Sum of `power` over third-octave bands; bin k lies at k * step_hz.
BandLevels in_bands(const Eigen::ArrayXd& power, double step_hz, const std::vector<double>& centres,
                    double floor) {
  BandLevels levels;
  const double edge = std::pow(2.0, 1.0 / 6);
  for (const double centre : centres) {
    const auto first = static_cast<long>(std::ceil(centre / edge / step_hz));
    const auto last =
        std::min(static_cast<long>(std::ceil(centre * edge / step_hz)), static_cast<long>(power.size()));
    const double sum = last > first ? power.segment(first, last - first).sum() : 0;
    levels.centre_hz.push_back(centre);
    levels.level_db.push_back(10 * std::log10(sum + floor));
  }
  return levels;
}

std::vector<double> third_octaves(double origin_hz, int from, int to) {
  std::vector<double> centres;
  for (int k = from; k <= to; ++k) centres.push_back(origin_hz * std::pow(2.0, k / 3.0));
  return centres;
}

/// `power` of frames, two-sided.
BandLevels in_third_octaves(const Eigen::ArrayXd& power) {
  return in_bands(power * (2.0 / kThirdOctaveFrame), kAnalysisRate / kThirdOctaveFrame,
                  third_octaves(1000, -12, 12), kSilence);
}

/// Squared magnitude `bins` from the middle of a Hann window's spectrum, over that of the middle.
double hann_spectrum(double bins) {
  if (bins == 0) return 1;
  if (std::fabs(bins) == 1) return 0.25;
  const double x = 0.5 * dsp::kTwoPi * bins, root = std::sin(x) / x / (1 - bins * bins);
  return root * root;
}

}  // namespace

BandLevels third_octave_levels(const std::vector<float>& x) {
  const Eigen::ArrayXf window = hann_window(kThirdOctaveFrame).cast<float>();
  const long size = static_cast<long>(x.size()), hop = kThirdOctaveFrame / 2;
  const long frames = 1 + std::max(0L, (size - kThirdOctaveFrame) / hop);
  const auto windowed = [&](long i, float* to) {
    Eigen::Map<Eigen::ArrayXf> frame(to, kThirdOctaveFrame);
    frame.setZero();
    if (i >= frames) return;
    const long start = i * hop, length = std::min<long>(kThirdOctaveFrame, size - start);
    frame.head(length) = Eigen::Map<const Eigen::ArrayXf>(x.data() + start, length) * window.head(length);
  };
  FramePair pair(kThirdOctaveFrame);
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(kThirdOctaveFrame / 2 + 1);
  for (long i = 0; i < frames; i += 2) {
    windowed(i, pair.first()), windowed(i + 1, pair.second());
    pair.forward();
    for (int k = 0; k <= kThirdOctaveFrame / 2; ++k) power(k) += static_cast<double>(pair.power(k));
  }
  return in_third_octaves(power / (static_cast<double>(frames) * window.cast<double>().square().sum()));
}

BandLevels third_octave_levels_of(const Eigen::ArrayXd& power) {
  const long finer = 2 * (power.size() - 1) / kThirdOctaveFrame, reach = kLobes * finer;
  Eigen::ArrayXd lobes(2 * reach + 1);
  for (long j = -reach; j <= reach; ++j)
    lobes(reach + j) = hann_spectrum(static_cast<double>(j) / static_cast<double>(finer));
  lobes /= lobes.sum();
  Eigen::ArrayXd heard = Eigen::ArrayXd::Zero(kThirdOctaveFrame / 2 + 1);
  for (long k = kLobes; k <= kThirdOctaveFrame / 2 - kLobes; ++k)  // no band reaches further
    heard(k) = std::max(0.0, (power.segment(k * finer - reach, lobes.size()) * lobes).sum());
  return in_third_octaves(heard);
}

BandLevels modulation_levels(const std::vector<float>& x) {
  const auto n = static_cast<long>(x.size()) / kEnvelopeHop;
  Eigen::ArrayXd e(n);
  for (long i = 0; i < n; ++i)
    e(i) = std::sqrt(Eigen::Map<const Eigen::ArrayXf>(x.data() + i * kEnvelopeHop, kEnvelopeHop)
                         .cast<double>()
                         .square()
                         .mean());
  e = e / std::max(e.mean(), 1e-30) - 1;
  const Eigen::ArrayXd window = hann_window(n);
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXd frame = e * window;
  Eigen::VectorXcd bins;
  if (n % 2) {  // the real transform needs an even length
    frame.conservativeResize(n + 1);
    frame(n) = 0;
  }
  fft.fwd(bins, frame);
  const Eigen::ArrayXd power = bins.array().abs2() / window.square().sum() / static_cast<double>(n) * 2;
  return in_bands(power, kAnalysisRate / kEnvelopeHop / static_cast<double>(frame.size()),
                  third_octaves(1, 0, 24), kNoModulation);
}

double power(const BandLevels& levels) {
  double sum = 0;
  for (const double level : levels.level_db) sum += std::pow(10, level / 10);
  return sum;
}

double mean_difference_db(const BandLevels& a, const BandLevels& b, double range_db, Difference difference) {
  const double loudest = *std::max_element(a.level_db.begin(), a.level_db.end());
  std::vector<double> d;
  for (std::size_t i = 0; i < a.level_db.size(); ++i)
    if (a.level_db[i] > loudest - range_db) d.push_back(b.level_db[i] - a.level_db[i]);
  double mean = 0, sum = 0;
  if (difference == Difference::kCentred)
    for (const double v : d) mean += v / static_cast<double>(d.size());
  for (const double v : d) sum += std::fabs(v - mean);
  return sum / static_cast<double>(d.size());
}

}  // namespace rigsound::analysis
