#include "clicks/paper_second_stage.hpp"

#include <algorithm>
#include <cmath>

#include "clicks/envelope.hpp"
#include "clicks/gaps.hpp"
#include "clicks/integrated_energy.hpp"
#include "clicks/train_power.hpp"
#include "numeric/nelder_mead.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kFlatnessWindow = 1024;
constexpr long kFlatnessHop = 64;   // the Hann energy holds nothing faster
constexpr double kLeastGain = 0.1;  // of the median beta
constexpr int kEvaluations = 150;

Eigen::ArrayXd squared_envelope(const ClickEnvelope& shape, long length) {
  Eigen::ArrayXd a2(length);
  for (long n = 0; n < length; ++n) a2(n) = std::pow(envelope(shape, static_cast<double>(n)), 2);
  return a2;
}

double mean_gap(const std::vector<EnergyPeak>& peaks) {
  return static_cast<double>(peaks.back().P_p - peaks.front().P_p) / static_cast<double>(peaks.size() - 1);
}

void drop_close_clicks(PaperClicks& clicks) {
  while (clicks.P.size() > 2) {
    const double median = median_gap(clicks.P);
    size_t closest = 1;
    for (size_t i = 1; i < clicks.P.size(); ++i)
      if (clicks.P[i] - clicks.P[i - 1] < clicks.P[closest] - clicks.P[closest - 1]) closest = i;
    if (static_cast<double>(clicks.P[closest] - clicks.P[closest - 1]) >= 0.5 * median) return;
    const long weaker =
        static_cast<long>(clicks.beta[closest - 1] < clicks.beta[closest] ? closest - 1 : closest);
    clicks.P.erase(clicks.P.begin() + weaker);
    clicks.beta.erase(clicks.beta.begin() + weaker);
  }
}

ClickEnvelope shape_of(const std::vector<double>& t) { return {t[0], t[1] / t[0], t[2]}; }

}  // namespace

PaperClicks paper_detection(const Eigen::ArrayXd& y, const std::vector<EnergyPeak>& peaks,
                            const ClickEnvelope& shape) {
  const long attack = std::lround(shape.attack_samples),
             width = std::max(attack + 2, std::lround(mean_gap(peaks) / 2));
  const Eigen::ArrayXd a2 = squared_envelope(shape, width), e = integrated_energy(y, a2, 0, 1);
  const double norm = a2.square().sum();
  PaperClicks clicks;
  for (const EnergyPeak& peak : peaks) {
    const long first = std::max(0L, peak.P_l - attack),
               last = std::min<long>(peak.P_r - attack, y.size() - 1);
    if (last <= first + 1) continue;
    long P = 0;
    const double most = e.segment(first, last - first + 1).maxCoeff(&P);
    P += first;
    if (!clicks.P.empty() && P <= clicks.P.back()) continue;
    clicks.P.push_back(P);
    clicks.beta.push_back(std::sqrt(most / norm));
  }
  drop_close_clicks(clicks);
  return clicks;
}

double flatness(const Eigen::ArrayXd& y, const PaperClicks& clicks, const ClickEnvelope& shape) {
  const double floor = kLeastGain * upper_median(clicks.beta);
  const Eigen::ArrayXd power =
      Eigen::Map<const Eigen::ArrayXd>(clicks.beta.data(), static_cast<long>(clicks.beta.size())).square();
  Eigen::ArrayXd g2;
  TrainPower(envelope_power(shape, 1), clicks.P, y.size()).spread(power, 0, g2);
  const Eigen::ArrayXd z = y / g2.max(floor * floor).sqrt();
  const long start = std::min<long>(clicks.P.front(), y.size() - 1);
  static const Eigen::ArrayXd window = squared_hann(kFlatnessWindow);
  const Eigen::ArrayXd f =
      integrated_energy(z.tail(z.size() - start), window, kFlatnessWindow / 2, kFlatnessHop);
  return (f - f.mean()).square().mean() / (f.mean() * f.mean());
}

ClickEnvelope paper_envelope(const Eigen::ArrayXd& y, const PaperClicks& clicks, const ClickEnvelope& start) {
  const double T = median_gap(clicks.P);
  SimplexOptions simplex;
  simplex.step = {0.3 * start.attack_samples, 1, 0.5 * start.decay};
  simplex.tolerance = {0.1, 0.01, 1e-3 * start.decay};
  simplex.lower = {2, -8, 0.1 / T};
  simplex.upper = {std::max(4.0, 0.5 * T), 8, 15 / T};
  simplex.evaluations = kEvaluations;
  return shape_of(nelder_mead([&](const std::vector<double>& t) { return flatness(y, clicks, shape_of(t)); },
                              {start.attack_samples, start.attack_bend * start.attack_samples, start.decay},
                              simplex));
}

ClickTrain paper_clicks(const Eigen::ArrayXd& y) {
  ClickTrain train;
  const FirstStage first = paper_first_stage(y);
  if (first.peaks.size() < 3) return train;
  ClickEnvelope halved = first.envelope;
  halved.decay /= 2;
  const PaperClicks coarse = paper_detection(y, first.peaks, halved);
  if (coarse.P.size() < 3) return train;
  train.envelope = paper_envelope(y, coarse, first.envelope);
  const PaperClicks fine = paper_detection(y, first.peaks, train.envelope);
  train.P.assign(fine.P.begin(), fine.P.end());
  train.beta = fine.beta;
  if (train.P.size() > 2) train.mean_gap_samples = median_gap(train.P);
  return train;
}

}  // namespace rigsound::analysis
