#include "bank/equaliser.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "bank/third_octave_meter.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/resynth.hpp"
#include "rigsound/dsp/energy.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kTaps = 1023;
constexpr int kDesign = 8192;  // points of the minimum-phase design
constexpr int kTail = 256;     // samples of ringing kept behind a click
constexpr double kMaxDb = 12;
constexpr int kSyntheses = 16;
constexpr double kSynthesisSeconds = 4, kSettleSeconds = 0.5;  // before, fewer clicks ring than later on

template <class Visit>
void each_test_synthesis(const ClickBank& bank, Visit visit) {
  for (std::uint64_t seed = 1; seed <= kSyntheses; ++seed) visit(resynthesise(bank, kSynthesisSeconds, seed));
}

BandLevels synthesised_levels(const ClickBank& bank) {
  BandLevels mean;
  ThirdOctaveMeter levels_of;
  const auto settled = static_cast<long>(kSettleSeconds * bank.sample_rate);
  each_test_synthesis(bank, [&](const Resynthesis& test) {
    const BandLevels here =
        levels_of(test.sound.data() + settled, static_cast<long>(test.sound.size()) - settled);
    mean.centre_hz = here.centre_hz;
    mean.level_db.resize(here.level_db.size(), 0.0);
    for (std::size_t b = 0; b < here.level_db.size(); ++b)
      mean.level_db[b] += std::pow(10, here.level_db[b] / 10) / kSyntheses;
  });
  for (double& level : mean.level_db) level = 10 * std::log10(level);
  return mean;
}

/// Straight lines in dB over log frequency, constant outside.
double interpolated(const std::vector<double>& centre_hz, const std::vector<double>& db, double f) {
  if (f <= centre_hz.front()) return db.front();
  if (f >= centre_hz.back()) return db.back();
  const auto above = std::upper_bound(centre_hz.begin(), centre_hz.end(), f) - centre_hz.begin();
  const double share = std::log(f / centre_hz[above - 1]) / std::log(centre_hz[above] / centre_hz[above - 1]);
  return db[above - 1] + share * (db[above] - db[above - 1]);
}

std::vector<float> filtered(const Click& click, const Eigen::ArrayXd& fir) {
  const auto size = static_cast<long>(click.size());
  long n = 1024;
  while (n < size + fir.size()) n *= 2;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXd a = Eigen::VectorXd::Zero(n), b = a, y;
  a.head(size) = Eigen::Map<const Eigen::VectorXf>(click.data(), size).cast<double>();
  b.head(fir.size()) = fir;
  Eigen::VectorXcd A, B;
  fft.fwd(A, a);
  fft.fwd(B, b);
  A.array() *= B.array();
  fft.inv(y, A, n);
  std::vector<float> out(static_cast<std::size_t>(size + kTail));
  for (long i = 0; i < size + kTail; ++i) {
    const double fade = std::min(1.0, static_cast<double>(size + kTail - i) / kTail);
    out[i] = static_cast<float>(fade * y(i));
  }
  return out;
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

/// Energy of a synthesis over the energies of its clicks: not 1 where overlapping clicks resemble each other.
double coherence(const ClickBank& bank) {
  double sound = 0, clicks = 0;
  each_test_synthesis(bank, [&](const Resynthesis& test) {
    sound += dsp::energy(test.sound);
    for (const ResynthImpact& impact : test.impacts)
      clicks += bank.mean_amplitude * impact.amplitude * bank.mean_amplitude * impact.amplitude;
  });
  return sound / clicks;
}

/// Samples from one click to the next, missed and double impacts counted in.
double mean_gap(const ClickBank& bank) {
  return bank.mean_gap_samples *
         (1 + (kMissGap - 1) * bank.miss_share + (kDoubleGap - 1) * bank.double_share);
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

void equalise(ClickBank& bank, const BandLevels& target) {
  const BandLevels now = synthesised_levels(bank);
  std::vector<double> gains_db;
  for (std::size_t b = 0; b < target.level_db.size(); ++b)
    gains_db.push_back(std::clamp(target.level_db[b] - now.level_db[b], -kMaxDb, kMaxDb));
  const Eigen::ArrayXd fir =
      minimum_phase_fir([&](double f) { return interpolated(target.centre_hz, gains_db, f); }, kTaps);
  for (Click& click : bank.clicks) click = filtered(click, fir);
  renormalise(bank);
}

void set_level(ClickBank& bank, double power) {
  const double spread = bank.amplitude_deviation / bank.mean_amplitude;
  const double B = std::sqrt(power * mean_gap(bank) / (coherence(bank) * (1 + spread * spread)));
  bank.amplitude_deviation *= B / bank.mean_amplitude;
  bank.mean_amplitude = B;
}

}  // namespace rigsound::analysis
