#include "denoise/cs_nmf.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/is_kernels.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kSecondsPerKnot = 2;
constexpr int kBackgroundUpdates = 30;
constexpr double kDearest = 0.4, kCostless = 0.8;  // decays, of the train's own
constexpr double kShallow = 15, kDeep = 25;        // dB that the train falls by from click to click

int noise_knots(int frames, int signal_words) {
  const double seconds = frames * kChainStft.hop / kAnalysisRate;
  return std::min(1 + static_cast<int>(std::ceil(seconds / kSecondsPerKnot - 1e-3)),
                  kMaxWords - signal_words);
}

/// What each word of the trains costs, in the order of the words; 1 is the usual.
std::vector<float> word_costs(const std::vector<TrainWords>& trains, float slow_cost, int words) {
  std::vector<float> cost(static_cast<std::size_t>(words), 1.0f);
  auto* word = cost.data();
  for (const TrainWords& train : trains) {
    const double own = train.clicks.envelope.decay * train.clicks.mean_gap_samples;
    const double fall_db = 20 / std::log(10.0) * own;
    const double most =
        static_cast<double>(slow_cost) * std::clamp((fall_db - kShallow) / (kDeep - kShallow), 0.0, 1.0);
    for (const double decay : train.decays) {
      const double slowness = (kCostless - decay / own) / (kCostless - kDearest);
      *word++ += static_cast<float>(most * std::clamp(slowness, 0.0, 1.0));
    }
  }
  return cost;
}

}  // namespace

Factors cs_nmf(const WordFit& clip, const std::vector<TrainWords>& trains, const CsNmfOptions& options) {
  const PowerSpectrogram& power = clip.power();
  Factors f;
  f.signal_words = kDecayCount * static_cast<int>(trains.size());
  const int knots = noise_knots(power.frames, f.signal_words), words = f.signal_words + knots;
  f.H = Grid(words, power.padded());
  for (std::size_t k = 0; k < trains.size(); ++k)
    f.H.middleRows(kDecayCount * static_cast<long>(k), kDecayCount) =
        click_activations(trains[k].clicks, trains[k].decays, power.frames, power.padded());
  f.H.bottomRows(knots) = hats(knots, power.frames, power.padded());
  f.W = Grid(power.bins(), words);
  const Eigen::ArrayXf noise = clip.noise(options.noise_start);
  const std::vector<float> cost = word_costs(trains, options.slow_cost, words);
  for (int m = 0; m < power.bins(); ++m) {
    const float mean = clip.mean()(m);
    f.W.row(m).head(f.signal_words) =
        std::max(mean - noise(m), 0.1f * mean) / static_cast<float>(f.signal_words);
    f.W.row(m).tail(knots) = noise(m);
  }
  clip.update(options.updates, cost.data(), f);
  return f;
}

Factors drilling_of_train(const Factors& factors, int k) {
  Factors own = factors;
  own.signal_words = kDecayCount;
  const int from = kDecayCount * k;  // its words move to the front, those before them behind
  own.W.leftCols(kDecayCount) = factors.W.middleCols(from, kDecayCount);
  own.W.middleCols(kDecayCount, from) = factors.W.leftCols(from);
  own.H.topRows(kDecayCount) = factors.H.middleRows(from, kDecayCount);
  own.H.middleRows(kDecayCount, from) = factors.H.topRows(from);
  return own;
}

Factors background_nmf(const WordFit& clip) {
  const PowerSpectrogram& power = clip.power();
  const int knots = noise_knots(power.frames, 0);
  Factors f;
  f.H = hats(knots, power.frames, power.padded());
  f.W = clip.mean().replicate(1, knots);
  clip.update(plain_updates(kBackgroundUpdates), nullptr, f);
  return f;
}

}  // namespace rigsound::analysis
