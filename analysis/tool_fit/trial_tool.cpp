#include "tool_fit/trial_tool.hpp"

#include "rigsound/analysis/rate.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/tool_player.hpp"
#include "tool_fit/blow.hpp"

namespace rigsound::analysis {

std::vector<double> one_blow(const ToolModel& model, std::size_t samples) {
  ToolModel steady = model;
  steady.strike.bounces = 0;
  steady.strike.amplitude_variation = 0;
  steady.strike.slope_variation = 0;
  ToolPlayer player(steady, kAnalysisRate, 1);
  std::vector<double> sound;
  for (std::size_t start = 0; start < samples; start += kChunk) {
    const bool here = kBeforeBlow >= start && kBeforeBlow < start + kChunk;
    const Impact blow{here ? static_cast<double>(kBeforeBlow - start) : 0.0, 1, 0};
    double out[kChunk];
    player.process({&blow, here ? 1 : 0}, out);
    sound.insert(sound.end(), out, out + kChunk);
  }
  sound.resize(samples);
  return sound;
}

}  // namespace rigsound::analysis
