#include "analysis/analyzer/learned_drill.hpp"

#include <cmath>

#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/simulate.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "scene/feed_axis.hpp"

namespace rigsound::analysis {
namespace {

/// The drilling alone: a set that a rig plays needs banks of rattling too.
SoundSet drilling_of(const std::filesystem::path& sound_set) {
  const config::SoundSetIndex index = config::load_index(sound_set);
  SoundSet sounds;
  for (const config::BankEntry& entry : index.banks) {
    sounds.uses.push_back({entry.situation, entry.rods, -1, static_cast<int>(sounds.banks.size()),
                           entry.feed_bar, entry.percussion_bar});
    sounds.banks.push_back(config::load_bank(sound_set / "banks" / entry.name).bank);
  }
  for (const config::LawsEntry& entry : index.laws) sounds.laws.push_back(entry.laws);
  return sounds;
}

}  // namespace

SoundSet learned_from_ramp(const std::filesystem::path& folder, const RampRequest& request) {
  write_feed_ramp(folder, request.seed, request.seconds);
  AnalyzerOptions options;
  options.inputs = {folder / "feed/ramp.wav"};
  options.rig = std::string(RIGSOUND_CONFIG) + "/rigs/demo.toml";
  options.sound_set = folder / "set";
  options.jobs = request.jobs;
  options.tool_version = "test";
  run_analyzer(options, {});
  return drilling_of(options.sound_set);
}

HeardDrill heard_at(const SoundSet& sounds, double feed_bar) {
  const scene::FeedPlace place = scene::FeedAxis(sounds, SceneOptions{}).place(feed_bar, 1, -1);
  double ln_gap = place.trend.ln_gap, energy = 0, energy_time = 0;
  for (int i = 0; i < place.banks.count; ++i) {
    const auto& [bank, share] = place.banks.choice[i];
    const double power = share * std::pow(bank->mean_amplitude, 2) * std::pow(10, bank->gain_db / 10);
    ln_gap += share * std::log(bank->mean_gap_samples / bank->sample_rate);
    energy += power, energy_time += power / bank->decay;
  }
  return {std::exp(-ln_gap), 10 * std::log10(energy) + place.trend.ln_level * 20 / dsp::kLn10,
          energy / energy_time * std::exp(place.trend.ln_decay)};
}

HeardErrors errors_at(const SoundSet& sounds, const DrillingLaws& truth, double feed_bar) {
  const HeardDrill heard = heard_at(sounds, feed_bar);
  const DrillingPoint p = truth.at(feed_bar, 1);
  return {heard.rate_hz / p.rate_hz - 1, heard.level_db - 20 * std::log10(p.norm), heard.decay / p.decay - 1};
}

}  // namespace rigsound::analysis
