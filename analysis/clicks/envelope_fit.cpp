#include "clicks/envelope_fit.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/nelder_mead.hpp"

namespace rigsound::analysis {
namespace {

enum Parameter { kLnAttack, kBend, kLnDecay, kShift };
constexpr int kFinalSweeps = 8;

ClickEnvelope envelope_of(const std::vector<double>& t) {
  const double N_a = std::exp(t[kLnAttack]);
  return {N_a, t[kBend] / N_a, std::exp(t[kLnDecay])};
}

double square(double x) { return x * x; }

/// Weak priors: an attack of 1.5 ms, no bend, 2.5 nepers a period.
double prior(const std::vector<double>& t, double T_0) {
  return 0.5 * square((t[kLnAttack] - std::log(72.0)) / 1.5) + 0.5 * square(t[kBend] / 3) +
         0.5 * square((t[kLnDecay] - std::log(2.5 / T_0)) / 1.2);
}

std::vector<long> shifted(const std::vector<long>& onset, double samples, int block) {
  std::vector<long> moved(onset);
  for (long& P : moved) P = std::lround(static_cast<double>(P) + samples / block);
  return moved;
}

SimplexOptions simplex(double T_0, const EnvelopeFitOptions& options) {
  SimplexOptions simplex;
  simplex.step = {0.7, 2.0, 0.5, -std::max<double>(options.block, 0.01 * T_0)};
  simplex.tolerance = {0.02, 0.02, 0.02, 0.5};
  simplex.lower = {std::log(2.0), -8, std::log(0.7 / T_0), -0.1 * T_0};
  simplex.upper = {std::log(0.3 * T_0), 8, std::log(15 / T_0), 0.1 * T_0};
  simplex.evaluations = options.evaluations;
  return simplex;
}

}  // namespace

void fit_envelope(const Eigen::ArrayXd& q, double T_0, const EnvelopeFitOptions& options,
                  ClickEnvelope& envelope, ModelClicks& clicks) {
  Eigen::ArrayXd v;
  const auto cost = [&](const std::vector<double>& t) {
    ModelClicks trial{shifted(clicks.onset, t[kShift], options.block), clicks.power, clicks.floor,
                      clicks.others};
    const TrainPower train(envelope_power(envelope_of(t), options.block), trial.onset, q.size());
    update_powers(q, train, options.sweeps, kOutlierClip, trial);
    model_variance(train, trial, v);
    return model_cost(q, v, options.block) + prior(t, T_0);
  };
  const std::vector<double> start = {std::log(envelope.attack_samples),
                                     envelope.attack_bend * envelope.attack_samples, std::log(envelope.decay),
                                     0};
  const std::vector<double> best = nelder_mead(cost, start, simplex(T_0, options));
  envelope = envelope_of(best);
  clicks.onset = shifted(clicks.onset, best[kShift], options.block);
  update_powers(q, TrainPower(envelope_power(envelope, options.block), clicks.onset, q.size()), kFinalSweeps,
                kOutlierClip, clicks);
}

ClickEnvelope first_envelope(const Eigen::ArrayXd& q, const std::vector<long>& onset, double T_0, int block) {
  const long period = static_cast<long>(T_0 / block);
  Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(period);
  int whole = 0;
  for (const long P : onset)
    if (P + period < q.size()) mean += q.segment(P, period).min(20 * q.mean()), ++whole;
  mean /= std::max(whole, 1);
  mean = (mean - 0.8 * mean.minCoeff()).max(1e-9);
  long peak = 0;
  mean.head(std::max(2L, period / 4)).maxCoeff(&peak);
  const long end = std::min(std::max(peak + 4, static_cast<long>(0.6 * static_cast<double>(period))), period);
  const Eigen::ArrayXd level = mean.segment(peak, end - peak).log();
  const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(end - peak, 0, static_cast<double>(end - peak - 1));
  const Eigen::ArrayXd centred = time - time.mean();
  const double slope = (centred * level).sum() / std::max(centred.square().sum(), 1e-9);
  return {std::max(2.0 * block, 0.03 * T_0), 0, std::clamp(-slope / 2 / block, 0.8 / T_0, 8 / T_0)};
}

}  // namespace rigsound::analysis
