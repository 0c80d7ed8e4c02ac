#include "denoise/beyond_chance.hpp"

#include <algorithm>

namespace rigsound::analysis {
namespace {

constexpr double kLeastShare = 1e-6;  // of S: a bin needs some

}  // namespace

MeanPsd psd_beyond_chance(const Factors& blind, const PowerSpectrogram& power, const Grid& background) {
  MeanPsd mean = mean_psd(blind, power);
  const Eigen::ArrayXd gain =
      (background - itakura_saito(power, blind)).rowwise().sum().cast<double>();  // nats
  const double by_chance = static_cast<double>(blind.signal_words) * power.frames / power.bins();
  for (long m = 0; m < gain.size(); ++m) {
    const long first = std::max(0L, m - 1), last = std::min(gain.size() - 1, m + 1);  // a window's lobe
    const double near = gain.segment(first, last - first + 1).mean();
    const double believed = mean.S(m) * std::max(kLeastShare, 1 - by_chance / std::max(near, by_chance));
    mean.N(m) += mean.S(m) - believed;
    mean.S(m) = believed;
  }
  return mean;
}

}  // namespace rigsound::analysis
