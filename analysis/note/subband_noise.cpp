#include "note/subband_noise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigsound::analysis {

double power_of(const Subband& d) {
  double sum = 0;
  for (const double v : d) sum += v * v;
  return d.empty() ? 0 : sum / static_cast<double>(d.size());
}

double take_mean(Subband& d) {
  double mean = 0;
  for (const double v : d) mean += v / static_cast<double>(d.size());
  for (double& v : d) v -= mean;
  return mean;
}

dsp::LinearPrediction prediction_of(const Subband& d, int order) {
  std::vector<double> r;
  for (std::size_t lag = 0; lag <= static_cast<std::size_t>(order); ++lag) {
    double sum = lag == 0 ? 1e-30 : 0;
    for (std::size_t i = 0; i + lag < d.size(); ++i) sum += d[i] * d[i + lag];
    r.push_back(sum);
  }
  return dsp::levinson(r);
}

double OneOverF::variance(int n) const { return std::exp2(level + gamma * n); }

OneOverF fit_one_over_f(const std::vector<double>& variances) {
  double w = 0, wn = 0, wv = 0;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const double weight = std::exp2(-static_cast<double>(i + 1));
    w += weight, wn += weight * static_cast<double>(i + 1), wv += weight * std::log2(variances[i] + 1e-30);
  }
  double covariance = 0, spread = 0;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const double weight = std::exp2(-static_cast<double>(i + 1)), n = static_cast<double>(i + 1) - wn / w;
    covariance += weight * n * (std::log2(variances[i] + 1e-30) - wv / w), spread += weight * n * n;
  }
  OneOverF law;
  law.gamma = spread > 0 ? covariance / spread : 0;
  law.level = wv / w - law.gamma * wn / w;
  return law;
}

Subband noise_like(const Subband& original, const NoiseShape& shape, std::mt19937_64& chance) {
  std::normal_distribution<double> normal;
  const std::size_t size = original.size();
  const bool coloured = shape.order > 0 && size >= 3 * static_cast<std::size_t>(shape.order);
  Subband z;
  if (!coloured) {
    for (std::size_t i = 0; i < size; ++i) z.push_back(std::sqrt(shape.variance) * normal(chance));
  } else {
    const dsp::LinearPrediction model = prediction_of(original, shape.order);
    const double gain = std::sqrt(std::max(0.0, model.error) * shape.variance);
    const std::size_t settle = 8 * static_cast<std::size_t>(shape.order) + 32;
    Subband y(size + settle, 0.0);
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] = gain * normal(chance);
      for (std::size_t k = 1; k < std::min(model.a.size(), i + 1); ++k) y[i] -= model.a[k] * y[i - k];
    }
    z.assign(y.end() - static_cast<std::ptrdiff_t>(size), y.end());
  }
  return with_energy_of(original, std::move(z), shape.window);
}

Subband with_energy_of(const Subband& original, Subband noise, int coefficients) {
  if (coefficients <= 0) return noise;
  const auto window = static_cast<std::size_t>(coefficients);
  const double mean = power_of(original) + 1e-30;
  for (std::size_t start = 0; start < noise.size(); start += window) {
    const std::size_t end = std::min(noise.size(), start + window);
    const Subband part(original.begin() + static_cast<std::ptrdiff_t>(start),
                       original.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t i = start; i < end; ++i) noise[i] *= std::sqrt(power_of(part) / mean);
  }
  return noise;
}

Subband as_strong_as(const Subband& original, Subband noise) {
  take_mean(noise);
  const double gain = std::sqrt(power_of(original) / (power_of(noise) + 1e-300));
  for (double& v : noise) v *= gain;
  return noise;
}

}  // namespace rigsound::analysis
