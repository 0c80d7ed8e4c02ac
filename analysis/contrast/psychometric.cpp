#include "contrast/psychometric.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/nelder_mead.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/dsp/random.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kResamples = 400;
constexpr double kMiddleShare = 0.95;

double farthest(const std::vector<Trial>& trials) {
  double most = 0;
  for (const Trial& trial : trials) most = std::max(most, trial.away_bar);
  return most;
}

double unlikelihood(const Psychometric& curve, const std::vector<Trial>& trials) {
  double sum = 0;
  for (const Trial& trial : trials) {
    const double p = curve.right(trial.away_bar);
    sum -= trial.right * std::log(p) + (trial.of - trial.right) * std::log(1 - p);
  }
  return sum;
}

/// The same numbers of trials, told right by chance as the curve has it.
std::vector<Trial> drawn_anew(const Psychometric& curve, std::vector<Trial> trials,
                              const dsp::RandomField& random) {
  std::uint64_t index = 0;
  for (Trial& trial : trials) {
    const double p = curve.right(trial.away_bar);
    trial.right = 0;
    for (int i = 0; i < trial.of; ++i) trial.right += random.uniform(index++, 0) < p ? 1 : 0;
  }
  return trials;
}

}  // namespace

double Psychometric::right(double away_bar) const {
  return 0.5 + (0.5 - kLapses) * (1 - std::exp(-std::pow(away_bar / scale_bar, slope)));
}

double Psychometric::away_bar(double right) const {
  return scale_bar * std::pow(-std::log(1 - (right - 0.5) / (0.5 - kLapses)), 1 / slope);
}

Psychometric fit_psychometric(const std::vector<Trial>& trials) {
  const double most = farthest(trials);
  const auto curve = [](const std::vector<double>& v) {
    return Psychometric{std::exp(v[0]), std::exp(v[1])};
  };
  SimplexOptions options;
  options.step = {0.5, 0.3}, options.tolerance = {1e-3, 1e-3};
  options.lower = {std::log(1e-3 * most), std::log(0.5)};
  options.upper = {std::log(1e2 * most), std::log(8.0)};
  std::vector<double> best;
  for (const double start : {0.1, 0.5}) {  // a curve that is flat at its start leads nowhere
    const auto cost = [&](const std::vector<double>& v) { return unlikelihood(curve(v), trials); };
    const std::vector<double> found = nelder_mead(cost, {std::log(start * most), std::log(2.0)}, options);
    if (best.empty() || cost(found) < cost(best)) best = found;
  }
  return curve(best);
}

Reach reach_of(const std::vector<Trial>& trials, std::uint64_t seed) {
  Reach reach;
  if (trials.empty()) return reach;
  const double most = farthest(trials);
  const Psychometric curve = fit_psychometric(trials);
  std::vector<double> away;
  for (int i = 0; i < kResamples; ++i) {
    const dsp::RandomField random(seed, static_cast<std::uint64_t>(i));
    away.push_back(fit_psychometric(drawn_anew(curve, trials, random)).away_bar(kToldRight));
  }
  reach.away_bar = curve.away_bar(kToldRight);
  reach.found = reach.away_bar <= most;
  reach.low_bar = quantile(away, (1 - kMiddleShare) / 2);
  reach.high_bar = quantile(away, (1 + kMiddleShare) / 2);
  reach.scale_bar = curve.scale_bar, reach.slope = curve.slope;
  return reach;
}

}  // namespace rigsound::analysis
