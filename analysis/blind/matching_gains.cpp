#include <algorithm>
#include <cmath>

#include "contrast/loudness.hpp"
#include "rigsound/analysis/blind_sounds.hpp"
#include "rigsound/analysis/contrast.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kMostGain_db = 40, kHighestPeak_db = -1;

double phon(LoudnessBands levels, double gain_db) {
  for (double& level : levels) level += gain_db;
  return loudness_level_phon(loudness_sone(levels));
}

/// The gain with which `levels` are as loud as `wanted_phon`; 0 where none is.
double matching_gain_db(const LoudnessBands& levels, double wanted_phon) {
  double low = -kMostGain_db, high = kMostGain_db;
  if (phon(levels, low) > wanted_phon || phon(levels, high) < wanted_phon) return 0;
  while (high - low > 1e-4) {
    const double middle = (low + high) / 2;
    (phon(levels, middle) < wanted_phon ? low : high) = middle;
  }
  return (low + high) / 2;
}

double peak_db(const std::vector<float>& x) {
  float peak = 0;
  for (const float value : x) peak = std::max(peak, std::fabs(value));
  return 20 * std::log10(static_cast<double>(peak) + 1e-30);
}

}  // namespace

std::vector<double> matching_gains_db(const std::vector<std::vector<float>>& sounds) {
  const double full_scale_db_spl = ContrastOptions{}.full_scale_db_spl;
  std::vector<double> gains_db;
  double wanted_phon = 0, highest_db = kHighestPeak_db;
  for (const std::vector<float>& sound : sounds) {
    const LoudnessBands levels = loudness_bands(sound, full_scale_db_spl);
    if (gains_db.empty()) wanted_phon = phon(levels, 0);
    gains_db.push_back(gains_db.empty() ? 0 : matching_gain_db(levels, wanted_phon));
    highest_db = std::max(highest_db, peak_db(sound) + gains_db.back());
  }
  for (double& gain : gains_db) gain -= highest_db - kHighestPeak_db;
  return gains_db;
}

}  // namespace rigsound::analysis
