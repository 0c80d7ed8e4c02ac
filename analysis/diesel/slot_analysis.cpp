#include "diesel/slot_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "diesel/hbwt.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kMaxSpread = 1.5, kMaxRho = 0.9, kClip = 3;  // clip in robust standard deviations

/// psi'(x): recurrence to x >= 8, then the asymptotic series; error below 1e-9.
double trigamma(double x) {
  double sum = 0;
  for (; x < 8; x += 1) sum += 1 / (x * x);
  const double z = 1 / (x * x);
  return sum + 1 / x + z / 2 + z / x * (1.0 / 6 - z * (1.0 / 30 - z * (1.0 / 42 - z / 30)));
}

/// MDCT frames of a block: frame t = r L + l spans angle samples (t - 1) M ... (t + 1) M.
struct SlotFrames {
  SlotFrames(const CycleBlock& block, int slots)
      : L(slots), M(block.N / slots), cycles(block.cycles), X(mdct_frames(block.y, M)) {
    open.assign(static_cast<std::size_t>(L * cycles), 1);
    for (int l = 0; l < L; ++l) open[l] = 0;  // the first cycle lacks its past
    if (block.open.empty()) return;
    for (int t = L; t < L * cycles; ++t)
      for (int i = (t - 1) * M; i < (t + 1) * M; ++i)
        if (!block.open[i]) open[t] = 0;
  }
  double at(int t, int q) const { return X[t * M + q]; }
  bool usable(int t) const { return open[t] != 0; }

  int L, M, cycles;
  std::vector<double> X;
  std::vector<char> open;
};

/// Mean of X^2 per slot and channel. A slot no gate ever opened for takes the mean of its neighbours.
std::vector<double> variances(const SlotFrames& f) {
  std::vector<double> v(static_cast<std::size_t>(f.L * f.M), 0.0);
  std::vector<int> count(static_cast<std::size_t>(f.L), 0);
  for (int t = 0; t < f.L * f.cycles; ++t) {
    if (!f.usable(t)) continue;
    const auto l = static_cast<std::size_t>(t % f.L);
    ++count[l];
    for (int q = 0; q < f.M; ++q)
      v[l * static_cast<std::size_t>(f.M) + static_cast<std::size_t>(q)] += f.at(t, q) * f.at(t, q);
  }
  // The mean cycle was taken off: of n values n - 1 are left.
  for (int l = 0; l < f.L; ++l)
    for (int q = 0; q < f.M; ++q) v[l * f.M + q] /= std::max(1, count[l] - 1);
  for (int l = 0; l < f.L; ++l) {
    if (count[l] >= 2) continue;
    int before = l, after = l;
    for (int step = 0; step < f.L && count[before] < 2; ++step) before = (before + f.L - 1) % f.L;
    for (int step = 0; step < f.L && count[after] < 2; ++step) after = (after + 1) % f.L;
    for (int q = 0; q < f.M; ++q) v[l * f.M + q] = 0.5 * (v[before * f.M + q] + v[after * f.M + q]);
  }
  return v;
}

/// ln of each frame's power over its slot's mean, centred and clipped; 0 where closed.
std::vector<double> log_gains(const SlotFrames& f, const std::vector<double>& v, std::vector<double>& s2) {
  std::vector<double> gains(static_cast<std::size_t>(f.L * f.cycles), 0.0);
  for (int l = 0; l < f.L; ++l) {
    const double* row = &v[l * f.M];
    double sum = 0, squares = 0;
    for (int q = 0; q < f.M; ++q) sum += row[q], squares += row[q] * row[q];
    const double effective = sum * sum / (squares + 1e-300);  // channels that share the power
    std::vector<double> logs;
    std::vector<int> at;
    for (int t = l; t < f.L * f.cycles; t += f.L) {
      if (!f.usable(t)) continue;
      double g = 0;
      for (int q = 0; q < f.M; ++q) g += f.at(t, q) * f.at(t, q);
      logs.push_back(std::log(g / (sum + 1e-300) + 1e-12)), at.push_back(t);
    }
    if (logs.empty()) {
      s2.push_back(0);
      continue;
    }
    const double centre = upper_median(logs);
    std::vector<double> away;
    for (double& x : logs) x -= centre, away.push_back(std::fabs(x));
    const double limit = kClip * (1.4826 * upper_median(away) + 1e-6);
    double mean = 0, square = 0;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      const double x = std::clamp(logs[i], -limit, limit);
      gains[at[i]] = x;
      mean += x / static_cast<double>(logs.size()), square += x * x / static_cast<double>(logs.size());
    }
    const double spread = logs.size() < 8 ? 0 : square - mean * mean - trigamma(std::max(1.0, effective) / 2);
    s2.push_back(std::clamp(spread, 0.0, kMaxSpread));
  }
  return gains;
}

}  // namespace

void learn_slots(const CycleBlock& whitened, int L, DieselPoint& point) {
  const SlotFrames frames(whitened, L);
  const std::vector<double> v = variances(frames);
  const std::vector<int> edges = slot_band_edges(frames.M);
  point.slot_variance.clear();
  for (int l = 0; l < L; ++l)
    for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
      double sum = 0;
      for (int q = edges[b]; q < edges[b + 1]; ++q) sum += v[l * frames.M + q];
      point.slot_variance.push_back(static_cast<float>(sum / (edges[b + 1] - edges[b])));
    }
  std::vector<double> s2;
  const std::vector<double> gains = log_gains(frames, v, s2);
  point.slot_log_variance.assign(s2.begin(), s2.end());
  double product = 0, mean_s2 = 0;
  int pairs = 0;
  for (int t = L; t < L * frames.cycles; ++t)
    if (frames.usable(t) && frames.usable(t - 1)) product += gains[t] * gains[t - 1], ++pairs;
  for (const double s : s2) mean_s2 += s / L;
  point.slot_correlation = std::clamp(product / std::max(1, pairs) / std::max(mean_s2, 1e-3), 0.0, kMaxRho);
}

void learn_grains(const CycleBlock& whitened, int count, DieselPoint& point) {
  const auto N = static_cast<std::size_t>(whitened.N);
  const auto length = static_cast<std::size_t>(whitened.N * (1 + kGrainOverlap));
  const int usable = whitened.cycles - 2;  // the last one needs the start of the next
  count = std::min(count, usable);
  double all = 0, kept = 0;
  for (const double v : whitened.y) all += v * v / static_cast<double>(whitened.y.size());
  point.grains.clear();
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(1 + static_cast<long>(i) * usable / count) * N;
    point.grains.emplace_back(whitened.y.begin() + static_cast<std::ptrdiff_t>(at),
                              whitened.y.begin() + static_cast<std::ptrdiff_t>(at + length));
    for (std::size_t n = 0; n < N; ++n)
      kept +=
          whitened.y[at + n] * whitened.y[at + n] / static_cast<double>(N * static_cast<std::size_t>(count));
  }
  const auto gain = static_cast<float>(std::sqrt(all / (kept + 1e-300)));
  for (auto& grain : point.grains)
    for (float& v : grain) v *= gain;
}

}  // namespace rigsound::analysis
