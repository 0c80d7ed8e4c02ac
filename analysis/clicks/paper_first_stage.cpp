#include "clicks/paper_first_stage.hpp"

#include <algorithm>
#include <cmath>

#include "clicks/integrated_energy.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kDetectionWindow = 1023, kEnvelopeWindow = 511;
constexpr double kRipple = 1e-4;         // of the largest energy: lower maxima are rounding in near silence
constexpr double kSmallestDecay = 1e-6;  // 1/sample

Eigen::ArrayXd hann_energy(const Eigen::ArrayXd& y, int length) {
  return integrated_energy(y, squared_hann(length), length / 2, 1);
}

std::vector<EnergyPeak> find_peaks(const Eigen::ArrayXd& e) {
  std::vector<EnergyPeak> peaks;
  const double least = kRipple * e.maxCoeff();
  for (long n = 1; n + 1 < e.size(); ++n)
    if (e(n) > e(n - 1) && e(n) >= e(n + 1) && e(n) > least) peaks.push_back({0, n, 0});
  for (size_t i = 0; i < peaks.size(); ++i) {
    const long before = i > 0 ? peaks[i - 1].P_p : 0,
               after = i + 1 < peaks.size() ? peaks[i + 1].P_p : e.size() - 1;
    e.segment(before, peaks[i].P_p - before + 1).minCoeff(&peaks[i].P_l);
    peaks[i].P_l += before;
    e.segment(peaks[i].P_p, after - peaks[i].P_p + 1).minCoeff(&peaks[i].P_r);
    peaks[i].P_r += peaks[i].P_p;
  }
  return peaks;
}

ClickEnvelope envelope_through(const std::vector<EnergyPeak>& peaks, const Eigen::ArrayXd& nu) {
  std::vector<double> attack, bend;
  double decay = 0;
  for (const auto& [P_l, P_p, P_r] : peaks) {
    attack.push_back(static_cast<double>(P_p - P_l));
    const double r = std::clamp(nu((P_p + P_l) / 2) / nu(P_p), 0.02, 0.98);
    bend.push_back(2 * std::log(r / (1 - r)));
    decay -= std::log(nu(P_r) / nu(P_p)) / static_cast<double>(std::max(P_r - P_p, 1L));
  }
  const double N_a = std::max(upper_median(attack), 2.0);
  return {N_a, upper_median(bend) / N_a, std::max(decay / static_cast<double>(peaks.size()), kSmallestDecay)};
}

}  // namespace

FirstStage paper_first_stage(const Eigen::ArrayXd& y) {
  FirstStage stage;
  stage.peaks = find_peaks(hann_energy(y, kDetectionWindow));
  if (stage.peaks.empty()) return stage;
  stage.envelope = envelope_through(stage.peaks, (hann_energy(y, kEnvelopeWindow) + 1e-30).sqrt());
  return stage;
}

}  // namespace rigsound::analysis
