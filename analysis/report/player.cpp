#include "report/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audio/sound_bytes.hpp"
#include "rigsound/analysis/data_uri.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kPeak = 0.89;  // -1 dB re full scale, of the loudest

std::vector<float> excerpt(const std::vector<float>& x, std::size_t most) {
  return {x.begin(), x.begin() + static_cast<long>(std::min(x.size(), most))};
}

double rms(const std::vector<float>& x) {
  double square = 0;
  for (const float v : x) square += static_cast<double>(v) * static_cast<double>(v);
  return std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, x.size())));
}

double peak(const std::vector<float>& x) {
  double highest = 0;
  for (const float v : x) highest = std::max(highest, std::fabs(static_cast<double>(v)));
  return highest;
}

std::string decibel_text(double gain) {
  const double db = 20 * std::log10(gain);
  return fmt::format("{}{:.1f} dB", db < -0.05 ? "−" : "+", std::fabs(db));
}

std::string take(const char* name, const std::vector<float>& sound, double gain) {
  std::vector<float> played;
  for (const float v : sound) played.push_back(static_cast<float>(gain * static_cast<double>(v)));
  return fmt::format(
      "<label><span>{0}</span><audio controls loop preload=\"metadata\" aria-label=\"{0}\" "
      "src=\"{1}\"></audio></label>\n",
      name, chart::data_uri("audio/flac", flac_bytes(played, static_cast<int>(kAnalysisRate))));
}

}  // namespace

std::string player(const HeardSounds& sounds) {
  const std::size_t length =
      std::min(sounds.recorded.size(), static_cast<std::size_t>(kHeard_s * kAnalysisRate));
  const std::vector<float> recorded = excerpt(sounds.recorded, length),
                           drilling = excerpt(sounds.drilling, length),
                           synthesised = excerpt(sounds.synthesised, length);
  const double matched = rms(drilling) / std::max(1e-9, rms(synthesised)),
               gain = kPeak / std::max({1e-9, peak(recorded), peak(drilling), matched * peak(synthesised)});
  return fmt::format(
             "<figure class=\"player\" role=\"group\" aria-label=\"Sound: recorded, drilling, "
             "synthesised\">\n"
             "<figcaption>Sound, {:.1f} s from {:.1f} s on. Recorded and drilling are played {}, the one "
             "being a part of the other; synthesised {}, which makes its mean level that of the drilling. "
             "Keys 1, 2, 3 choose; time goes on.</figcaption>\n",
             static_cast<double>(recorded.size()) / kAnalysisRate, sounds.start_s, decibel_text(gain),
             decibel_text(gain * matched)) +
         take("recorded", recorded, gain) + take("drilling", drilling, gain) +
         take("synthesised", synthesised, gain * matched) + "</figure>\n";
}

}  // namespace rigsound::analysis
