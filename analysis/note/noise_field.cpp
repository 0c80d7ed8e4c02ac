#include "note/noise_field.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/fft.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kCoefficientsAnOrder = 4;

/// Power at `order` times the fundamental.
double field_density(const HbwtShape& shape, const FieldSpectra& wanted, double order) {
  const auto q = static_cast<std::size_t>(std::min(shape.P - 1, static_cast<int>(2 * order)));
  const double distance = std::fabs(order - std::round(order));
  int n = 1;
  while (n <= shape.N && distance <= std::ldexp(1.0, -n - 1)) ++n;
  // Of the scaling band the harmonic is at angle 0; a scale of the wavelets is turned round by decimation.
  const double angle =
      n > shape.N ? 2 * M_PI * std::ldexp(distance, shape.N) : 2 * M_PI * (1 - std::ldexp(distance, n));
  return wanted[static_cast<std::size_t>(n - 1)][q].density(angle);
}

}  // namespace

double SubbandSpectrum::density(double angle) const {
  if (predictor.size() == 1) return variance;
  double re = 0, im = 0;
  for (std::size_t k = 0; k < predictor.size(); ++k) {
    re += predictor[k] * std::cos(static_cast<double>(k) * angle);
    im += predictor[k] * std::sin(static_cast<double>(k) * angle);
  }
  return variance * gain / (re * re + im * im);
}

SubbandSpectrum subband_spectrum(const Subband& d, double variance, int order) {
  SubbandSpectrum spectrum;
  spectrum.variance = variance;
  if (order <= 0 || d.size() < kCoefficientsAnOrder * static_cast<std::size_t>(order)) return spectrum;
  const dsp::LinearPrediction model = prediction_of(d, order);
  spectrum.predictor = model.a;
  spectrum.gain = model.error;
  return spectrum;
}

HbwtCoefficients<double> noise_field(const HbwtShape& shape, int length, const FieldSpectra& wanted,
                                     std::mt19937_64& chance) {
  int size = 1;
  while (size < length) size *= 2;
  std::normal_distribution<double> normal;
  std::vector<double> re(static_cast<std::size_t>(size)), im(re.size(), 0.0);
  for (double& v : re) v = normal(chance);
  const dsp::Fft<double> fft(size);
  fft.forward(re.data(), im.data());
  for (int b = 0; b <= size / 2; ++b) {
    const double gain =
        std::sqrt(field_density(shape, wanted, static_cast<double>(b) * shape.P / size)) / size;
    re[b] *= gain, im[b] *= gain;
    if (b > 0 && b < size / 2) re[size - b] *= gain, im[size - b] *= gain;
  }
  fft.inverse(re.data(), im.data());
  re.resize(static_cast<std::size_t>(length));
  return hbwt(re, shape);
}

}  // namespace rigsound::analysis
