#include "tool_fit/band_analyser.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "rigsound/analysis/rate.hpp"
#include "tool_fit/impact_sound.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kDecayFrame = 256, kHalfDecayFrame = kDecayFrame / 2, kDecayHop = 64;  // 5.3 ms
constexpr double kSilence = 1e-14;

/// Energy of the bins around `centre`, the outermost shared with the neighbouring band.
double band_energy(const std::vector<double>& power, double hz_a_bin, double centre) {
  const double low = centre * std::pow(2, -1.0 / 6) / hz_a_bin,
               high = centre * std::pow(2, 1.0 / 6) / hz_a_bin;
  double sum = 0;
  const auto last = std::min(power.size() - 1, static_cast<std::size_t>(high + 0.5));
  for (auto k = static_cast<std::size_t>(low + 0.5); k <= last; ++k) {
    const double from = std::max(low, static_cast<double>(k) - 0.5),
                 to = std::min(high, static_cast<double>(k) + 0.5);
    if (to > from) sum += (to - from) * power[k];
  }
  return sum;
}

double db(double energy) { return 10 * std::log10(energy + kSilence); }

}  // namespace

BandAnalyser::BandAnalyser(double highest_hz) {
  for (double centre = 125; centre * std::pow(2, 1.0 / 6) <= highest_hz; centre *= std::pow(2, 1.0 / 3))
    centre_hz_.push_back(centre);
  for (std::size_t i = 0; i < kDecayFrame; ++i)
    window_.push_back(std::sin(M_PI * (static_cast<double>(i) + 0.5) / kDecayFrame));
  fft_.SetFlag(Eigen::FFT<double>::HalfSpectrum);
}

std::vector<double> BandAnalyser::power_spectrum(const std::vector<double>& x) {
  std::vector<std::complex<double>> X;
  fft_.fwd(X, x);
  std::vector<double> power;
  power.reserve(X.size());
  for (const std::complex<double>& bin : X) power.push_back(std::norm(bin));
  return power;
}

void BandAnalyser::add_decays(const std::vector<double>& sound, BandProfile& profile) {
  const std::size_t bands = centre_hz_.size();
  profile.decay_db.resize(bands);
  std::vector<double> sum(bands, 0.0), frame(kDecayFrame);
  std::size_t stretch = 0, frames = 0;
  for (std::size_t start = 0; start + kDecayFrame <= sound.size() && stretch < std::size(kStretch_s);
       start += kDecayHop) {
    for (std::size_t i = 0; i < kDecayFrame; ++i) frame[i] = sound[start + i] * window_[i];
    const std::vector<double> power = power_spectrum(frame);
    for (std::size_t b = 0; b < bands; ++b)
      sum[b] += band_energy(power, kAnalysisRate / kDecayFrame, centre_hz_[b]);
    ++frames;
    const double middle = (static_cast<double>(start + kHalfDecayFrame) - kBeforeImpact) / kAnalysisRate;
    if (middle < kStretch_s[stretch]) continue;
    for (std::size_t b = 0; b < bands; ++b)
      profile.decay_db[b].push_back(db(sum[b] / static_cast<double>(frames)));
    std::fill(sum.begin(), sum.end(), 0.0);
    frames = 0, ++stretch;
  }
}

BandProfile BandAnalyser::analyse(const std::vector<double>& sound) {
  BandProfile profile;
  std::size_t size = 1024;
  while (size < sound.size()) size *= 2;
  std::vector<double> padded = sound;
  padded.resize(size, 0.0);
  const std::vector<double> power = power_spectrum(padded);
  for (const double centre : centre_hz_)
    profile.level_db.push_back(
        db(band_energy(power, kAnalysisRate / static_cast<double>(size), centre) / kAnalysisRate));
  add_decays(sound, profile);
  return profile;
}

}  // namespace rigsound::analysis
