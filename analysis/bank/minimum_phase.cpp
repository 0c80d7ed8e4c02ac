#include "bank/minimum_phase.hpp"

#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kDesign = 8192;

}  // namespace

Eigen::ArrayXd minimum_phase_fir(const std::function<double(double)>& gain_db, int taps) {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXcd spectrum(kDesign / 2 + 1);
  for (int k = 0; k <= kDesign / 2; ++k)
    spectrum(k) = gain_db(k * kAnalysisRate / kDesign) * std::log(10.0) / 20;
  Eigen::VectorXd cepstrum, response;
  fft.inv(cepstrum, spectrum, kDesign);
  // Everything before time zero is folded behind it: the log magnitude stays, the phase becomes the smallest.
  cepstrum.segment(1, kDesign / 2 - 1) *= 2;
  cepstrum.tail(kDesign / 2 - 1).setZero();
  fft.fwd(spectrum, cepstrum);
  spectrum = spectrum.array().exp();
  fft.inv(response, spectrum, kDesign);
  return response.head(taps).array();
}

}  // namespace rigsound::analysis
