#include "engine/tool/sound_levels.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace rigsound::tests {
namespace {

constexpr int kHalf = 256;  // taps on either side of the middle

std::vector<double> highpass_taps(double rate) {
  std::vector<double> taps;
  for (int i = -kHalf; i <= kHalf; ++i) {
    const double t = M_PI * i / (kHalf + 1), cut = 2 * 12000 / rate;
    const double window =
        0.35875 + 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) + 0.01168 * std::cos(3 * t);
    const double low = i == 0 ? cut : std::sin(M_PI * cut * i) / (M_PI * i);
    taps.push_back(window * ((i == 0) - low));
  }
  return taps;
}

}  // namespace

std::vector<double> third_octaves_db(const std::vector<double>& sound, double rate) {
  std::vector<std::complex<double>> X;
  Eigen::FFT<double>().fwd(X, sound);
  const double hz = rate / static_cast<double>(X.size());
  std::vector<double> levels;
  for (double centre = 125; centre < 15000; centre *= std::pow(2, 1.0 / 3)) {
    double sum = 0;
    for (std::size_t k = 1; k < X.size() / 2; ++k) {
      const double f = hz * static_cast<double>(k);
      if (f >= centre * std::pow(2, -1.0 / 6) && f < centre * std::pow(2, 1.0 / 6))
        sum += std::norm(X[k]) / (rate * rate) * hz;
    }
    levels.push_back(10 * std::log10(sum));
  }
  return levels;
}

double largest_difference_db(const std::vector<std::vector<double>>& levels) {
  double worst = 0;
  for (std::size_t band = 0; band < levels.front().size(); ++band) {
    const auto below = [band](const auto& a, const auto& b) { return a[band] < b[band]; };
    const auto [least, most] = std::minmax_element(levels.begin(), levels.end(), below);
    worst = std::max(worst, (*most)[band] - (*least)[band]);
  }
  return worst;
}

double residue_db(const std::vector<double>& sound, double rate, double from_s, double to_s) {
  const std::vector<double> taps = highpass_taps(rate);
  double peak = 0, high_peak = 0;
  for (const double x : sound) peak = std::max(peak, std::fabs(x));
  for (auto n = static_cast<int>(from_s * rate); n < static_cast<int>(to_s * rate); ++n) {
    double sum = 0;
    for (int i = -kHalf; i <= kHalf; ++i)
      sum += taps[static_cast<std::size_t>(i + kHalf)] * sound[static_cast<std::size_t>(n - i)];
    high_peak = std::max(high_peak, std::fabs(sum));
  }
  return 20 * std::log10(high_peak / peak);
}

}  // namespace rigsound::tests
