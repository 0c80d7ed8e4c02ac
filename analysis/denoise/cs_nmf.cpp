#include "denoise/cs_nmf.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/is_kernels.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kSecondsPerKnot = 2;
constexpr int kBackgroundIterations = 30;
constexpr double kDearest = 0.4, kCostless = 0.8;  // decays, of the train's own
constexpr double kShallow = 15, kDeep = 25;        // dB that the train falls by from click to click

int noise_knots(int frames) {
  const double seconds = frames * kChainStft.hop / kAnalysisRate;
  return std::min(1 + static_cast<int>(std::ceil(seconds / kSecondsPerKnot - 1e-3)), kMaxWords - kDecayCount);
}

std::vector<float> word_costs(const ClickTrain& train, const CsNmfOptions& options, int words) {
  const double own = train.envelope.decay * train.mean_gap_samples;
  const double fall_db = 20 / std::log(10.0) * own;
  const auto most = static_cast<double>(options.slow_cost) *
                    std::clamp((fall_db - kShallow) / (kDeep - kShallow), 0.0, 1.0);
  std::vector<float> cost(static_cast<std::size_t>(words), 1.0f);
  for (std::size_t j = 0; j < options.decays.size(); ++j) {
    const double slowness = (kCostless - options.decays[j] / own) / (kCostless - kDearest);
    cost[j] += static_cast<float>(most * std::clamp(slowness, 0.0, 1.0));
  }
  return cost;
}

}  // namespace

Factors cs_nmf(const PowerSpectrogram& power, const ClickTrain& train, const CsNmfOptions& options) {
  const int knots = noise_knots(power.frames), words = kDecayCount + knots;
  Factors f;
  f.signal_words = kDecayCount;
  f.H = Grid(words, power.padded());
  f.H.topRows(kDecayCount) = click_activations(train, options.decays, power.frames, power.padded());
  f.H.bottomRows(knots) = hats(knots, power.frames, power.padded());
  f.W = Grid(power.bins(), words);
  const Eigen::ArrayXf noise = noise_level(power, options.noise_start);
  const std::vector<float> cost = word_costs(train, options, words);
  const Activations H{f.H.data(), words, power.padded(), cost.data()};
  for (int m = 0; m < power.bins(); ++m) {
    const float mean = power.P.row(m).head(power.frames).mean();
    f.W.row(m).head(kDecayCount) = std::max(mean - noise(m), 0.1f * mean) / kDecayCount;
    f.W.row(m).tail(knots) = noise(m);
    is_kernels().fit_bin(power.P.row(m).data(), H, f.W.row(m).data(), options.iterations, 1.0f, kWordFloor);
  }
  return f;
}

Factors background_nmf(const PowerSpectrogram& power) {
  const int knots = noise_knots(power.frames);
  Factors f;
  f.H = hats(knots, power.frames, power.padded());
  f.W = Grid(power.bins(), knots);
  const Activations H{f.H.data(), knots, power.padded()};
  for (int m = 0; m < power.bins(); ++m) {
    f.W.row(m) = power.P.row(m).head(power.frames).mean();
    is_kernels().fit_bin(power.P.row(m).data(), H, f.W.row(m).data(), kBackgroundIterations, 1.0f,
                         kWordFloor);
  }
  return f;
}

}  // namespace rigsound::analysis
