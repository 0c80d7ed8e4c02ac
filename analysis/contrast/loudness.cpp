#include "contrast/loudness.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "rigsound/analysis/rate.hpp"
#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kSilence_db = -60;
constexpr int kFrame = 65536;  // bins of 0.73 Hz: eight of them in the lowest band
constexpr int kLow = 11;       // bands up to 250 Hz, which are weighted and put together to three
constexpr int kCritical = 20;  // approximated critical bands

// Annex A's tables from here on. Ranges of level, and what is added to the levels of the lowest bands within
// each.
constexpr int kRanges = 8;
constexpr double kRangeEnd[kRanges] = {45, 55, 65, 71, 80, 90, 100, 120};
constexpr double kLowWeight[kRanges][kLow] = {
    {-32, -24, -16, -10, -5, 0, -7, -3, 0, -2, 0}, {-29, -22, -15, -10, -4, 0, -7, -2, 0, -2, 0},
    {-27, -19, -14, -9, -4, 0, -6, -2, 0, -2, 0},  {-25, -17, -12, -9, -3, 0, -5, -2, 0, -2, 0},
    {-23, -16, -11, -7, -3, 0, -4, -1, 0, -1, 0},  {-20, -14, -10, -6, -3, 0, -4, -1, 0, -1, 0},
    {-18, -12, -9, -6, -2, 0, -3, -1, 0, -1, 0},   {-15, -10, -8, -4, -2, 0, -3, -1, 0, -1, 0}};

// Threshold in quiet, transmission of the ear, third octave to critical band.
constexpr double kThreshold[kCritical] = {30, 18, 12, 8, 7, 6, 5, 4, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
constexpr double kTransmission[kCritical] = {0,    0,    0,    0,    0,    0,  0,    0, 0, 0,
                                             -0.5, -1.6, -3.2, -5.4, -5.6, -4, -1.5, 2, 5, 12};
constexpr double kBandWidth[kCritical] = {-0.25, -0.6, -0.8, -0.8, -0.5, 0,   0.5, 1.1, 1.5, 1.7,
                                          1.8,   1.8,  1.7,  1.6,  1.4,  1.2, 0.8, 0.5, 0,   -0.5};

// Where critical bands end, Bark, and how steeply specific loudness falls above them,
// sone/Bark, from the loudness at which each steepness ends.
constexpr double kBandEnd[kCritical + 1] = {0.9,  1.8,  2.8,  3.5,  4.4,  5.4,  6.6,  7.9,  9.2,  10.6, 12.3,
                                            13.8, 15.2, 16.7, 18.1, 19.3, 20.6, 21.8, 22.7, 23.6, 24.0};
constexpr int kSteps = 18, kSteepBands = 8;
constexpr double kStepEnd[kSteps] = {21.5, 18,   15.1, 11.5, 9,    6.1,  4.4,  3.1,   2.13,
                                     1.36, 0.82, 0.42, 0.30, 0.22, 0.15, 0.10, 0.035, 0};
constexpr double kSteepness[kSteps][kSteepBands] = {
    {13, 8.2, 6.3, 5.5, 5.5, 5.5, 5.5, 5.5},          {9, 7.5, 6, 5.1, 4.5, 4.5, 4.5, 4.5},
    {7.8, 6.7, 5.6, 4.9, 4.4, 3.9, 3.9, 3.9},         {6.2, 5.4, 4.6, 4, 3.5, 3.2, 3.2, 3.2},
    {4.5, 3.8, 3.6, 3.2, 2.9, 2.7, 2.7, 2.7},         {3.7, 3, 2.8, 2.35, 2.2, 2.2, 2.2, 2.2},
    {2.9, 2.3, 2.1, 1.9, 1.8, 1.7, 1.7, 1.7},         {2.4, 1.7, 1.5, 1.35, 1.3, 1.3, 1.3, 1.3},
    {1.95, 1.45, 1.3, 1.15, 1.1, 1.1, 1.1, 1.1},      {1.5, 1.2, 0.94, 0.86, 0.82, 0.82, 0.82, 0.82},
    {0.72, 0.67, 0.64, 0.63, 0.62, 0.62, 0.62, 0.62}, {0.59, 0.53, 0.51, 0.50, 0.42, 0.42, 0.42, 0.42},
    {0.40, 0.33, 0.26, 0.24, 0.24, 0.22, 0.22, 0.22}, {0.27, 0.21, 0.20, 0.18, 0.17, 0.17, 0.17, 0.17},
    {0.16, 0.15, 0.14, 0.12, 0.11, 0.11, 0.11, 0.11}, {0.12, 0.11, 0.10, 0.08, 0.08, 0.08, 0.08, 0.08},
    {0.09, 0.08, 0.07, 0.06, 0.06, 0.06, 0.06, 0.05}, {0.06, 0.05, 0.03, 0.02, 0.02, 0.02, 0.02, 0.02}};

double power_of(double level_db) { return std::pow(10, level_db / 10); }
double level_of(double power) { return 10 * std::log10(power + 1e-30); }

/// Mean square per bin, one-sided.
Eigen::ArrayXd power_spectrum(const std::vector<float>& x) {
  const Eigen::ArrayXd window = hann(kFrame).cast<double>();
  const auto size = static_cast<long>(x.size());
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXd frame(kFrame);
  Eigen::VectorXcd bins;
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(kFrame / 2 + 1);
  double weight = 0;  // a frame that the sound fills in part counts in part
  for (long start = 0; start == 0 || start + kFrame <= size; start += kFrame / 2) {
    const long length = std::min<long>(kFrame, size - start);
    frame.setZero();
    frame.head(length) = Eigen::Map<const Eigen::ArrayXf>(x.data() + start, length).cast<double>();
    frame.array() *= window;
    fft.fwd(bins, frame);
    power += bins.array().abs2();
    weight += window.head(length).square().sum();
  }
  return power * (2 / (weight * kFrame));
}

/// |H|^2 of the band-pass.
double passed(double hz, double centre_hz) {
  constexpr double kRelativeWidth = 0.23156;  // 2^(1/6) - 2^(-1/6)
  const double detuning = (hz / centre_hz - centre_hz / hz) / kRelativeWidth, d2 = detuning * detuning;
  return 1 / (1 + d2 * d2 * d2);
}

/// The three lowest critical bands, dB.
std::array<double, 3> low_levels(const LoudnessBands& levels) {
  constexpr int kEnd[3] = {6, 9, kLow};
  std::array<double, 3> together{};
  for (int band = 0, critical = 0; band < kLow; ++band) {
    if (band == kEnd[critical]) ++critical;
    int range = 0;
    while (range < kRanges - 1 && levels[band] > kRangeEnd[range] - kLowWeight[range][band]) ++range;
    together[critical] += power_of(levels[band] + kLowWeight[range][band]);
  }
  for (double& level : together) level = level_of(level);
  return together;
}

/// Core loudness of each critical band, sone/Bark; above the last one there is none.
std::array<double, kCritical + 1> core_loudness(const LoudnessBands& levels) {
  constexpr double kThresholdFactor = 0.25;
  const std::array<double, 3> low = low_levels(levels);
  std::array<double, kCritical + 1> core{};
  for (int band = 0; band < kCritical; ++band) {
    const double excited = (band < 3 ? low[band] : levels[band + kLow - 3]) - kTransmission[band];
    if (excited <= kThreshold[band]) continue;
    const double over = excited - kBandWidth[band] - kThreshold[band];
    const double root = std::pow(1 - kThresholdFactor + kThresholdFactor * power_of(over), 0.25);
    core[band] = std::max(0.0, 0.0635 * std::pow(10, 0.025 * kThreshold[band]) * (root - 1));
  }
  // The threshold rises within the lowest band.
  core[0] *= std::min(1.0, 0.4 + 0.32 * std::pow(core[0], 0.2));
  return core;
}

}  // namespace

LoudnessBands loudness_bands(const std::vector<float>& x, double full_scale_db_spl) {
  const Eigen::ArrayXd power = power_spectrum(x);
  const double step_hz = kAnalysisRate / kFrame, full_scale_power = 0.5;
  LoudnessBands levels{};
  for (int band = 0; band < kLoudnessBands; ++band) {
    const double centre_hz = 1000 * std::pow(10, (band - 16) / 10.0);
    double sum = 0;
    // Two octaves away the filter passes less than -90 dB.
    const long first = static_cast<long>(centre_hz / 4 / step_hz) + 1,
               last = std::min<long>(static_cast<long>(4 * centre_hz / step_hz), power.size() - 1);
    for (long bin = first; bin <= last; ++bin)
      sum += power(bin) * passed(static_cast<double>(bin) * step_hz, centre_hz);
    levels[band] = std::max(kSilence_db, level_of(sum / full_scale_power) + full_scale_db_spl);
  }
  return levels;
}

/// Area under specific loudness over the critical-band rate: flat where a band's core is higher than what
/// falls off the bands below, along the slopes where it is not.
double loudness_sone(const LoudnessBands& levels) {
  const auto core = core_loudness(levels);
  double area = 0, at = 0, height = 0;
  for (int band = 0; band <= kCritical; ++band) {
    const int steep = std::clamp(band - 1, 0, kSteepBands - 1);
    while (at < kBandEnd[band]) {
      if (height <= core[band]) {
        area += core[band] * (kBandEnd[band] - at);
        at = kBandEnd[band], height = core[band];
        continue;
      }
      int step = 0;
      while (step < kSteps - 1 && height <= kStepEnd[step]) ++step;
      const double slope = kSteepness[step][steep];
      const double lower = std::max(kStepEnd[step], core[band]);
      const double width = std::min((height - lower) / slope, kBandEnd[band] - at);
      area += width * (height - width * slope / 2);
      at += width, height -= width * slope;
      if (at + 1e-9 > kBandEnd[band]) at = kBandEnd[band];
    }
  }
  return area;
}

double loudness_level_phon(double sone) {
  return sone >= 1 ? 40 + 10 * std::log2(sone) : std::max(3.0, 40 * std::pow(sone + 0.0005, 0.35));
}

}  // namespace rigsound::analysis
