#include "tool_fit/band_picture.hpp"

#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "rigsound/analysis/chain.hpp"
#include "tool_fit/blow.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kFrame = 256, kHop = 64;  // 5.3 ms, for the decays
constexpr double kSilence = 1e-14;

std::vector<double> power_spectrum(std::vector<double> x) {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> X;
  fft.fwd(X, x);
  std::vector<double> power;
  power.reserve(X.size());
  for (const std::complex<double>& bin : X) power.push_back(std::norm(bin));
  return power;
}

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

void add_decays(const std::vector<double>& sound, BandPicture& picture) {
  picture.decay_db.resize(picture.centre_hz.size());
  std::vector<std::vector<double>> energy(picture.centre_hz.size());
  for (std::size_t start = 0; start + kFrame <= sound.size(); start += kHop) {
    std::vector<double> frame(kFrame);
    for (std::size_t i = 0; i < kFrame; ++i)
      frame[i] = sound[start + i] * std::sin(M_PI * (static_cast<double>(i) + 0.5) / kFrame);
    const std::vector<double> power = power_spectrum(std::move(frame));
    for (std::size_t b = 0; b < energy.size(); ++b)
      energy[b].push_back(band_energy(power, kAnalysisRate / kFrame, picture.centre_hz[b]));
  }
  for (std::size_t b = 0; b < energy.size(); ++b) {
    double sum = 0;
    std::size_t stretch = 0, frames = 0;
    for (std::size_t i = 0; i < energy[b].size() && stretch < std::size(kStretch_s); ++i) {
      sum += energy[b][i], ++frames;
      const double middle = (static_cast<double>(i * kHop + kFrame / 2) - kBeforeBlow) / kAnalysisRate;
      if (middle < kStretch_s[stretch]) continue;
      picture.decay_db[b].push_back(db(sum / static_cast<double>(frames)));
      sum = 0, frames = 0, ++stretch;
    }
  }
}

}  // namespace

BandPicture band_picture(const std::vector<double>& sound, double highest_hz) {
  BandPicture picture;
  std::size_t size = 1024;
  while (size < sound.size()) size *= 2;
  std::vector<double> padded = sound;
  padded.resize(size, 0.0);
  const std::vector<double> power = power_spectrum(std::move(padded));
  for (double centre = 125; centre * std::pow(2, 1.0 / 6) <= highest_hz; centre *= std::pow(2, 1.0 / 3)) {
    picture.centre_hz.push_back(centre);
    picture.level_db.push_back(
        db(band_energy(power, kAnalysisRate / static_cast<double>(size), centre) / kAnalysisRate));
  }
  add_decays(sound, picture);
  return picture;
}

}  // namespace rigsound::analysis
