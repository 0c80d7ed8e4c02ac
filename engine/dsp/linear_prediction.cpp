#include "rigsound/dsp/linear_prediction.hpp"

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {

LinearPrediction levinson(const std::vector<double>& r) {
  LinearPrediction model;
  std::vector<double>& a = model.a;
  a.assign(r.size(), 0.0);
  a[0] = 1;
  double error = r[0];
  for (std::size_t i = 1; i < r.size(); ++i) {
    double sum = r[i];
    for (std::size_t j = 1; j < i; ++j) sum += a[j] * r[i - j];
    const double k = -sum / error;
    std::vector<double> next = a;
    for (std::size_t j = 1; j < i; ++j) next[j] = a[j] + k * a[i - j];
    next[i] = k;
    a.swap(next);
    error *= 1 - k * k;
  }
  model.error = error / r[0];
  return model;
}

std::vector<double> all_pole_at_rate(const std::vector<double>& a, double rate_from, double rate_to) {
  if (rate_from == rate_to) return a;
  constexpr int kBins = 4096;  // 6 Hz a bin at 48 kHz, finer than the sharpest pole of order 128
  std::vector<double> r(a.size(), 0.0);
  for (int bin = 0; bin < kBins; ++bin) {
    const double f = (bin + 0.5) / kBins * (rate_to / 2);
    const double at = f < rate_from / 2 ? f : rate_from / 2;
    const double w = kTwoPi * at / rate_from;
    double re = 0, im = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      re += a[k] * cos(w * static_cast<double>(k));
      im -= a[k] * sin(w * static_cast<double>(k));
    }
    const double power = 1 / (re * re + im * im);
    const double v = kTwoPi * f / rate_to;
    for (std::size_t lag = 0; lag < r.size(); ++lag) r[lag] += power * cos(v * static_cast<double>(lag));
  }
  return levinson(r).a;
}

}  // namespace rigsound::dsp
