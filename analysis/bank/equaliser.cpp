#include "bank/equaliser.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/energy.hpp"
#include "spectrum/frame_pair.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kTaps = 1023;
constexpr int kDesign = 8192;  // points of the minimum-phase design
constexpr int kTail = 256;     // samples of ringing kept behind a click
constexpr double kMaxDb = 12;

/// Straight lines in dB over log frequency, constant outside.
double interpolated(const std::vector<double>& centre_hz, const std::vector<double>& db, double f) {
  if (f <= centre_hz.front()) return db.front();
  if (f >= centre_hz.back()) return db.back();
  const auto above = std::upper_bound(centre_hz.begin(), centre_hz.end(), f) - centre_hz.begin();
  const double share = std::log(f / centre_hz[above - 1]) / std::log(centre_hz[above] / centre_hz[above - 1]);
  return db[above - 1] + share * (db[above] - db[above - 1]);
}

std::vector<float> faded(const float* x, std::size_t size) {
  std::vector<float> out(x, x + size);
  for (std::size_t n = 1; n < kTail; ++n) out[size - n] *= static_cast<float>(n) / kTail;
  return out;
}

/// All through `fir`, two at a time, with kTail samples more each that fade out.
void filter_clicks(const Eigen::ArrayXd& fir, std::vector<Click>& clicks) {
  std::size_t longest = 0;
  for (const Click& click : clicks) longest = std::max(longest, click.size());
  int points = 1024;
  while (points < static_cast<long>(longest) + fir.size()) points *= 2;
  FramePair response(points), pair(points);
  response.set(std::vector<float>(fir.begin(), fir.end()), {});
  response.forward();
  for (std::size_t c = 0; c < clicks.size(); c += 2) {
    const bool alone = c + 1 == clicks.size();
    pair.set(clicks[c], alone ? Click{} : clicks[c + 1]);
    pair.forward();
    for (int k = 0; k <= points / 2; ++k) {
      const std::complex<float> H = response.first_bin(k);
      pair.set_bins(k, H * pair.first_bin(k), H * pair.second_bin(k));
    }
    pair.inverse();
    clicks[c] = faded(pair.first(), clicks[c].size() + kTail);
    if (!alone) clicks[c + 1] = faded(pair.second(), clicks[c + 1].size() + kTail);
  }
}

/// Unit norm again; B takes over the gain the filter had on the mean click.
void renormalise(ClickBank& bank) {
  double power = 0;
  for (Click& click : bank.clicks) {
    const double energy = dsp::energy(click);
    std::vector<float> unit(click.begin(), click.end());
    dsp::divide(unit.data(), unit.size(), std::sqrt(energy));
    click = std::move(unit);
    power += energy / static_cast<double>(bank.clicks.size());
  }
  bank.mean_amplitude *= std::sqrt(power);
  bank.amplitude_deviation *= std::sqrt(power);
}

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

void equalise(ClickBank& bank, const ImpactPairs& pairs, const BandLevels& target) {
  const BandLevels now = EndlessSpectrum(pairs, bank).third_octaves();
  std::vector<double> gains_db;
  for (std::size_t b = 0; b < target.level_db.size(); ++b)
    gains_db.push_back(std::clamp(target.level_db[b] - now.level_db[b], -kMaxDb, kMaxDb));
  const Eigen::ArrayXd fir =
      minimum_phase_fir([&](double f) { return interpolated(target.centre_hz, gains_db, f); }, kTaps);
  filter_clicks(fir, bank.clicks);
  renormalise(bank);
}

void set_level(ClickBank& bank, const ImpactPairs& pairs, double power) {
  const double gain = std::sqrt(power / EndlessSpectrum(pairs, bank).mean_square());
  bank.mean_amplitude *= gain;
  bank.amplitude_deviation *= gain;
}

}  // namespace rigsound::analysis
