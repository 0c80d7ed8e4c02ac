#include "contrast/listening.hpp"

#include <algorithm>
#include <cmath>

#include "contrast/impact_rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kLowestModulation_hz = 3.9;  // below it a second is too short

double mean_difference(const BandLevels& a, const BandLevels& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.level_db.size(); ++i) sum += std::fabs(a.level_db[i] - b.level_db[i]);
  return sum / static_cast<double>(a.level_db.size());
}

}  // namespace

Heard listen(const std::vector<float>& x) {
  Heard heard{third_octave_levels(x), modulation_levels(x), impact_rate_hz(x)};
  for (double& level : heard.third_octaves.level_db) level = std::max(level, kFaintest_db);
  return heard;
}

Distance distance(const Heard& a, const Heard& b) {
  const double rates = a.rate_hz + b.rate_hz;
  return {mean_difference(a.third_octaves, b.third_octaves), mean_difference(a.modulation, b.modulation),
          rates > 0 ? 2 * std::fabs(a.rate_hz - b.rate_hz) / rates : 0};
}

Eigen::VectorXd noticed(const Heard& heard, const dsp::RandomField& ear, std::uint64_t index) {
  std::vector<double> values;
  const auto add = [&](double value, double noise) {
    const auto field = static_cast<std::uint64_t>(values.size());
    values.push_back(value + noise * ear.normal(64 * index + field, 0));
  };
  for (const double level : heard.third_octaves.level_db) add(level, kBandNoise_db);
  for (std::size_t i = 0; i < heard.modulation.level_db.size(); ++i)
    if (heard.modulation.centre_hz[i] > kLowestModulation_hz)
      add(heard.modulation.level_db[i], kModulationNoise_db);
  add(std::log(std::max(heard.rate_hz, kLowestRate_hz)), kRateNoise);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<long>(values.size()));
}

}  // namespace rigsound::analysis
