#include "diesel/crank_tracker.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "diesel/angle_domain.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/diesel_model.hpp"
#include "rigsound/dsp/fft.hpp"

namespace rigsound::analysis {
namespace {

using Wave = std::vector<double>;

constexpr int G = 512;  // template samples a cycle
constexpr double kBandLow_hz = 30, kBandHigh_hz = 1500;
constexpr double kSearch = 0.08;  // of a cycle, while the template runs
constexpr int kTrackingRounds = 6, kNeighbours = 8, kFineSearch = 24;
constexpr double kSmoothing = 10;  // Whittaker's lambda
constexpr double kWindow = 0.10;   // how far off a given speed may be to be found at all

/// The part of the sound that a cycle repeats, sampled no finer than the template can hold.
Wave tracking_band(const Wave& x, double f0) {
  const double high = std::min(kBandHigh_hz, 0.4 * G * f0);
  return zero_phase_low_pass(zero_phase_high_pass(x, kBandLow_hz, kAnalysisRate), high, kAnalysisRate);
}

/// Cubic Hermite through marks at 0, 1, 2, ...: slopes are central differences.
double between_marks(const Wave& marks, double cycle) {
  const auto size = static_cast<std::ptrdiff_t>(marks.size());
  const auto i = std::clamp(static_cast<std::ptrdiff_t>(std::floor(cycle)), std::ptrdiff_t{0}, size - 2);
  const auto mark = [&](std::ptrdiff_t j) {
    if (j < 0) return 2 * marks[0] - marks[1];
    if (j >= size) return 2 * marks[marks.size() - 1] - marks[marks.size() - 2];
    return marks[j];
  };
  const double t = cycle - static_cast<double>(i), a = mark(i), b = mark(i + 1);
  const double da = (b - mark(i - 1)) / 2, db = (mark(i + 2) - a) / 2;
  return a + t * da + t * t * (3 * (b - a) - 2 * da - db) + t * t * t * (da + db - 2 * (b - a));
}

struct Match {
  double shift = 0, correlation = 0;  // template samples
};

/// The shift of the middle cycle of `two` (2 G samples) that fits the template best.
Match best_match(const double* two, const Wave& tmpl, int reach) {
  double norm = 0;
  for (const double v : tmpl) norm += v * v;
  Wave c;
  for (int d = -reach; d <= reach; ++d) {
    double dot = 0, energy = 0;
    for (int i = 0; i < G; ++i) {
      const double v = two[G / 2 + d + i];
      dot += v * tmpl[i], energy += v * v;
    }
    c.push_back(dot / (std::sqrt(energy * norm) + 1e-20));
  }
  const auto best = static_cast<std::size_t>(std::max_element(c.begin(), c.end()) - c.begin());
  Match match{static_cast<double>(best) - reach, c[best]};
  if (best > 0 && best + 1 < c.size())
    match.shift += 0.5 * (c[best - 1] - c[best + 1]) / (c[best - 1] - 2 * c[best] + c[best + 1] - 1e-15);
  return match;
}

/// Two cycles around mark + cycle, from half a cycle before it.
Wave two_cycles(const Wave& band, double start, double period) {
  Wave positions;
  for (int i = -G / 2; i < G + G / 2; ++i) positions.push_back(start + period * i / G);
  return interpolated(band, positions, kQuickSinc);
}

Wave running_marks(const Wave& band, double period) {
  Wave marks, tmpl;
  double at = period, T = period;
  while (at + 2 * T < static_cast<double>(band.size())) {
    Wave two = two_cycles(band, at, T);
    if (tmpl.empty()) tmpl.assign(two.begin() + G / 2, two.begin() + G / 2 + G);
    const Match match = best_match(two.data(), tmpl, static_cast<int>(kSearch * G));
    const double trust = std::pow(std::clamp(match.correlation, 0.0, 1.0), 2);
    at += 0.7 * trust * match.shift / G * T;
    T = std::clamp(T * (1 + 0.05 * trust * match.shift / G), 0.9 * period, 1.1 * period);
    two = two_cycles(band, at, T);
    for (std::size_t i = 0; i < tmpl.size(); ++i) tmpl[i] = 0.85 * tmpl[i] + 0.15 * two[G / 2 + i];
    marks.push_back(at);
    at += T;
  }
  return marks;
}

/// Weighted smoothing of second differences (Whittaker 1923).
Wave smoothed(const Wave& value, const Wave& weight) {
  const auto n = static_cast<Eigen::Index>(value.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    entries.emplace_back(i, i, weight[i]);
    right[i] = weight[i] * value[i];
  }
  constexpr double kDifference[3] = {1, -2, 1};
  for (Eigen::Index i = 0; i + 2 < n; ++i)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        entries.emplace_back(i + a, i + b, kSmoothing * kDifference[a] * kDifference[b]);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd z = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
  return Wave(z.data(), z.data() + n);
}

/// One round: every cycle against the mean of its neighbours mixed with that of all (`global`, 0...1).
double align(const Wave& band, Wave& marks, double global) {
  const std::size_t cycles = marks.size() - 3;
  Wave positions;
  for (std::size_t r = 0; r < cycles; ++r)
    for (int i = -G / 2; i < G + G / 2; ++i)
      positions.push_back(between_marks(marks, static_cast<double>(r) + 1 + static_cast<double>(i) / G));
  const Wave all = interpolated(band, positions, kQuickSinc);
  Wave mean(G, 0.0), shift(cycles), weight(cycles);
  for (std::size_t r = 0; r < cycles; ++r)
    for (std::size_t i = 0; i < G; ++i) mean[i] += all[r * 2 * G + G / 2 + i] / static_cast<double>(cycles);
  double correlation = 0;
  for (std::size_t r = 0; r < cycles; ++r) {
    const std::size_t low = r > kNeighbours ? r - kNeighbours : 0,
                      high = std::min(cycles, r + kNeighbours + 1);
    Wave tmpl(G);
    for (std::size_t i = 0; i < G; ++i) tmpl[i] = global * mean[i];
    for (std::size_t j = low; j < high; ++j)
      for (std::size_t i = 0; i < G; ++i)
        tmpl[i] += (1 - global) * all[j * 2 * G + G / 2 + i] / static_cast<double>(high - low);
    const Match match = best_match(&all[r * 2 * G], tmpl, kFineSearch);
    shift[r] = match.shift;
    weight[r] = std::pow(std::clamp(match.correlation, 0.02, 1.0), 2);
    correlation += match.correlation / static_cast<double>(cycles);
  }
  const Wave z = smoothed(shift, weight);
  Wave moved = marks;
  for (std::size_t j = 0; j < marks.size(); ++j) {
    const std::size_t r = std::min(j > 0 ? j - 1 : 0, cycles - 1);
    const double T = j + 1 < marks.size() ? marks[j + 1] - marks[j] : marks[j] - marks[j - 1];
    moved[j] += z[r] / G * T;
  }
  marks = moved;
  return correlation;
}

CrankTrack refined(const Wave& band, Wave marks, double global) {
  CrankTrack track;
  if (marks.size() < 8) return track;
  for (int round = 0; round < kTrackingRounds; ++round) track.correlation = align(band, marks, global);
  track.first = static_cast<std::size_t>(std::ceil(std::max(0.0, marks.front())));
  // Invert the spline: theta is smooth, so a dense table and straight lines between are ample.
  constexpr int kFineSteps = 64;
  double before = marks.front(), angle = 0;
  std::size_t n = track.first;
  for (std::size_t cycle = 0; cycle + 1 < marks.size(); ++cycle)
    for (int i = 1; i <= kFineSteps; ++i) {
      const double next = static_cast<double>(cycle) + static_cast<double>(i) / kFineSteps;
      const double at = between_marks(marks, next);
      for (; static_cast<double>(n) <= at && n < band.size(); ++n)
        track.theta.push_back(angle + (static_cast<double>(n) - before) / (at - before) * (next - angle));
      before = at, angle = next;
    }
  return track;
}

}  // namespace

double CrankTrack::rpm() const {
  return theta.size() < 2 ? 0
                          : rpm_of_cycles(kAnalysisRate) * (theta.back() - theta.front()) /
                                static_cast<double>(theta.size() - 1);
}

double repeating_rpm(const std::vector<double>& x, double rpm) {
  const double f0 = cycles_per_second(rpm);
  const int factor = 8;
  const Wave band = decimated(tracking_band(x, f0), factor);
  const double period = kAnalysisRate / factor / f0;
  std::size_t size = 1;
  while (size < 2 * band.size()) size *= 2;
  Wave re(size, 0.0), im(size, 0.0);
  std::copy(band.begin(), band.end(), re.begin());
  const dsp::Fft<double> fft(static_cast<int>(size));
  fft.forward(re.data(), im.data());
  for (std::size_t i = 0; i < size; ++i) re[i] = re[i] * re[i] + im[i] * im[i], im[i] = 0;
  fft.inverse(re.data(), im.data());
  const auto low = static_cast<std::size_t>(period * (1 - kWindow)),
             high = static_cast<std::size_t>(period * (1 + kWindow));
  std::size_t best = 0;
  for (std::size_t lag = low; lag <= high && lag + 1 < band.size(); ++lag) {
    const auto unbiased = [&](std::size_t l) { return re[l] / static_cast<double>(band.size() - l); };
    const bool peak = unbiased(lag) > unbiased(lag - 1) && unbiased(lag) >= unbiased(lag + 1);
    if (peak && (best == 0 || unbiased(lag) > unbiased(best))) best = lag;
  }
  if (best == 0 || re[best] < 0.05 * re[0]) return 0;
  const double y0 = re[best - 1], y1 = re[best], y2 = re[best + 1];
  const double lag = static_cast<double>(best) + 0.5 * (y0 - y2) / (y0 - 2 * y1 + y2);
  return rpm_of_cycles(kAnalysisRate / factor) / lag;
}

CrankTrack track_steady(const std::vector<double>& x, double rpm) {
  const Wave band = tracking_band(x, cycles_per_second(rpm));
  return refined(band, running_marks(band, rpm_of_cycles(kAnalysisRate) / rpm), 0.5);
}

CrankTrack track_logged(const std::vector<double>& x, const std::vector<double>& rpm) {
  double slowest = rpm.front(), angle = 0;
  Wave marks;
  for (std::size_t n = 0; n < std::min(x.size(), rpm.size()); ++n) {
    slowest = std::min(slowest, rpm[n]);
    const double step = cycles_per_second(rpm[n]) / kAnalysisRate;
    if (std::floor(angle + step) > std::floor(angle))
      marks.push_back(static_cast<double>(n) + (std::ceil(angle) - angle) / step);
    angle += step;
  }
  return refined(tracking_band(x, cycles_per_second(slowest)), marks, 0.0);
}

}  // namespace rigsound::analysis
