#include "denoise/click_activations.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::analysis {
namespace {

// Energies are followed on a grid of 16 samples: eight points a hop, 1/32 of the window.
constexpr int kStep = 16, kHalfWindow = kChainStft.window / 2;
constexpr double kSlowestShare = 0.4, kSlowest = 0.5, kFastest = 12;

/// beta_i^2 shared between the two grid points around P_i. Grid point 0 is half a window before sample 0.
Eigen::ArrayXd impulses(const ClickTrain& train, int points) {
  Eigen::ArrayXd impulse = Eigen::ArrayXd::Zero(points);
  for (size_t i = 0; i < train.P.size(); ++i) {
    const double at = static_cast<double>(train.P[i] + kHalfWindow) / kStep;
    const int k = static_cast<int>(std::floor(at));
    if (k < 0 || k + 1 >= points) continue;
    const double energy = train.beta[i] * train.beta[i];
    impulse(k) += energy * (1 - (at - k));
    impulse(k + 1) += energy * (at - k);
  }
  return impulse;
}

/// The squared linear attack at the grid points from the onset to the last before the peak; none for a short
/// one.
Eigen::ArrayXd squared_attack(double N_a) {
  const long length = std::lround(N_a / kStep);
  return (Eigen::ArrayXd::LinSpaced(length, 0, static_cast<double>(length - 1)) / static_cast<double>(length))
      .square();
}

Eigen::ArrayXd convolve(const Eigen::ArrayXd& x, const Eigen::ArrayXd& kernel) {
  Eigen::ArrayXd y = Eigen::ArrayXd::Zero(x.size());
  for (long k = 0; k < std::min(kernel.size(), x.size()); ++k)
    y.tail(x.size() - k) += kernel(k) * x.head(x.size() - k);
  return y;
}

}  // namespace

Decays decays_around(const ClickTrain& train) {
  const double slowest =
      std::clamp(kSlowestShare * train.envelope.decay * train.mean_gap_samples, kSlowest, kFastest / 2);
  Decays decays{};
  for (int j = 0; j < kDecayCount; ++j)
    decays[j] = slowest * std::pow(kFastest / slowest, j / (kDecayCount - 1.0));
  return decays;
}

Grid click_activations(const ClickTrain& train, const Decays& decays, int frames, int padded) {
  const int hop = kChainStft.hop / kStep, width = kChainStft.window / kStep,
            points = frames * hop + width + 1;
  const Eigen::ArrayXd impulse = impulses(train, points),
                       attack = squared_attack(train.envelope.attack_samples);
  const Eigen::ArrayXd rising = convolve(impulse, attack);
  const long rise = attack.size();
  const Eigen::ArrayXd window = hann(kChainStft.window)(Eigen::seqN(0, width, kStep)).cast<double>();
  const Eigen::ArrayXd weight = window.square() / window.square().sum();
  Grid rows = Grid::Zero(kDecayCount, padded);
  for (int j = 0; j < kDecayCount; ++j) {
    const double factor = std::exp(-2 * decays[j] / train.mean_gap_samples * kStep);
    Eigen::ArrayXd energy = rising;
    double tail = 0;
    for (long n = rise; n < points; ++n) energy(n) += tail = tail * factor + impulse(n - rise);
    for (int n = 0; n < frames; ++n)
      rows(j, n) = static_cast<float>((energy.segment(n * hop, width) * weight).sum());
    rows.row(j) /= std::max(rows.row(j).head(frames).mean(), 1e-30f);
  }
  return rows;
}

}  // namespace rigsound::analysis
