#include "bank/click_masks.hpp"

#include <algorithm>
#include <cmath>

#include "clicks/envelope.hpp"
#include "clicks/gaps.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kDecayDb = 60, kMaxPeriods = 6, kMaxSeconds = 0.5;
constexpr double kEmpty = 1e-12;  // where no click sounds the mask is zero, not 0/0

std::vector<double> envelope_samples(const ClickTrain& clicks) {
  const double decayed =
      clicks.envelope.attack_samples + std::log(10.0) * kDecayDb / 20 / clicks.envelope.decay;
  const double periods = kMaxPeriods * median_gap(clicks.P);
  const double length = std::min({decayed, periods, kMaxSeconds * kAnalysisRate});
  std::vector<double> a(static_cast<std::size_t>(std::max(length, 2.0)));
  for (std::size_t n = 0; n < a.size(); ++n) a[n] = envelope(clicks.envelope, static_cast<double>(n));
  return a;
}

}  // namespace

ClickMasks::ClickMasks(const ClickTrain& clicks, long frames)
    : clicks_(clicks), a_(envelope_samples(clicks)), g_(static_cast<std::size_t>(frames), 0.0) {
  for (std::size_t i = 0; i < clicks.P.size(); ++i) {
    const long length = std::min<long>(click_length(), frames - clicks.P[i]);
    for (long n = 0; n < length; ++n) {
      const double response = clicks.beta[i] * a_[n];
      g_[clicks.P[i] + n] += response * response;
    }
  }
  for (double& g : g_) g = std::sqrt(g);
}

std::vector<double> ClickMasks::mask(std::size_t i) const {
  const long length = std::min<long>(click_length(), static_cast<long>(g_.size()) - clicks_.P[i]);
  std::vector<double> m(static_cast<std::size_t>(std::max(length, 0L)));
  for (std::size_t n = 0; n < m.size(); ++n) {
    const double g = g_[clicks_.P[i] + n];
    m[n] = g > kEmpty ? std::min(clicks_.beta[i] * a_[n] / g, 1.0) : 0.0;
  }
  return m;
}

std::vector<float> ClickMasks::extract(const std::vector<float>& x, std::size_t i) const {
  const std::vector<double> m = mask(i);
  std::vector<float> click(m.size());
  for (std::size_t n = 0; n < m.size(); ++n) click[n] = static_cast<float>(x[clicks_.P[i] + n] * m[n]);
  return click;
}

}  // namespace rigsound::analysis
