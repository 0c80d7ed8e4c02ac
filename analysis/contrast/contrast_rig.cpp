#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "rigsound/analysis/contrast.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/machine/signal.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kComparedRods[] = {1, 6, 20};
constexpr double kSettled_s = 3;  // the diesel has started, whatever is smoothed has arrived

/// Names of the banks that serve a situation.
std::vector<std::string> banks_of(const SoundSet& sounds, Situation situation) {
  std::vector<std::string> names;
  for (const BankUse& use : sounds.uses) {
    const std::string& name = sounds.banks[static_cast<std::size_t>(use.bank)].name;
    if (use.situation == situation && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  }
  return names;
}

DrillSetting setting_of(Situation situation, const scene::FeedPoints& points) {
  DrillSetting setting;
  switch (situation) {
    case Situation::kNormal:
      setting.feed_bar = points.normal;
      break;
    case Situation::kUnderfeed:
      setting.feed_bar = points.underfeed;
      break;
    case Situation::kOverfeed:
      setting.feed_bar = points.overfeed;
      break;
    case Situation::kClosedRattling:
      setting.rattling = Rattling::kClosed;
      break;
    case Situation::kOpenRattling:
      setting.rattling = Rattling::kOpen;
      break;
  }
  return setting;
}

std::string words(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// A drill string sounds of its rods and its rock; without one, banks that were recorded with several counts
/// do.
bool hears_rods(const SoundSet& sounds, const BoomOptions& boom) {
  std::set<int> counts;
  for (const BankUse& use : sounds.uses)
    if (use.rods > 0) counts.insert(use.rods);
  return boom.drill_string >= 0 || counts.size() > 1;
}

void add_rods_and_rocks(const SoundSet& sounds, const BoomOptions& boom, ContrastPlan& plan) {
  const DrillSetting normal = plan.situations.front().setting;
  const bool rods = hears_rods(sounds, boom);
  for (const int count : kComparedRods) {
    if (!rods) break;
    DrillSetting setting = normal;
    setting.rods = count;
    plan.rods.push_back({count == 1 ? "1 rod" : std::to_string(count) + " rods", {}, setting});
  }
  for (std::size_t i = 0; i < sounds.rocks.size() && sounds.rocks.size() > 1; ++i) {
    DrillSetting setting = normal;
    setting.rock = static_cast<int>(i);
    plan.rocks.push_back({sounds.rocks[i].name, {}, setting});
  }
}

ContrastPlan plan_of(const config::Rig& rig, std::size_t boom, const SoundSet& sounds) {
  ContrastPlan plan;
  plan.sound_set = rig.sound_set;
  plan.scene = rig.engine.scene;
  plan.points = scene::feed_points(plan.scene);
  plan.lowest_bar = plan.scene.contact_bar + plan.scene.hysteresis_bar;
  plan.highest_bar = info(Signal::kFeedPressureBar).max;
  for (int s = 0; s < kSituationCount; ++s) {
    const auto situation = static_cast<Situation>(s);
    plan.situations.push_back(
        {words(name(situation)), banks_of(sounds, situation), setting_of(situation, plan.points)});
  }
  add_rods_and_rocks(sounds, rig.engine.booms[boom], plan);
  return plan;
}

MachineState state_of(const DrillSetting& setting, std::size_t boom, double engine_rpm) {
  MachineState state;
  state.engine_rpm = static_cast<float>(engine_rpm);
  BoomState& drill = state.boom[boom];
  drill.feed_pressure_bar = static_cast<float>(setting.feed_bar);
  drill.rattling = setting.rattling;
  drill.rod_count = static_cast<std::uint8_t>(setting.rods);
  drill.rock = static_cast<std::uint16_t>(setting.rock);
  return state;
}

/// Both loudspeakers together: a sound in the middle keeps its power.
float mixed_down(const float* frame, int channels) {
  const float sum = channels > 1 ? frame[0] + frame[1] : frame[0];
  return channels > 1 ? sum * static_cast<float>(M_SQRT1_2) : sum;
}

std::vector<float> rendered(const config::Rig& rig, const SoundSet& sounds, const MachineState& state,
                            double seconds) {
  Engine engine = config::build_engine(rig, sounds);
  const EngineOptions& o = engine.options();
  const auto frames_of = [&](double s) { return static_cast<std::size_t>(std::lround(s * o.sample_rate)); };
  const std::size_t skipped = frames_of(kSettled_s + o.scene.open_burst_s), wanted = frames_of(seconds);
  std::vector<float> block(static_cast<std::size_t>(o.block * o.channels)), sound;
  sound.reserve(wanted);
  for (std::size_t frame = 0; sound.size() < wanted; frame += static_cast<std::size_t>(o.block)) {
    engine.process(state, block.data());
    for (int i = 0; i < o.block && sound.size() < wanted; ++i)
      if (frame + static_cast<std::size_t>(i) >= skipped)
        sound.push_back(mixed_down(&block[static_cast<std::size_t>(i * o.channels)], o.channels));
  }
  return sound;
}

}  // namespace

ContrastRig contrast_rig(config::Rig rig, std::size_t boom, double engine_rpm) {
  rig.audio.rate = static_cast<int>(kAnalysisRate);
  rig.engine.sample_rate = kAnalysisRate;
  SoundSet sounds = config::load_sounds(rig);
  const ContrastPlan plan = plan_of(rig, boom, sounds);
  const auto shared =
      std::make_shared<const std::pair<config::Rig, SoundSet>>(std::move(rig), std::move(sounds));
  const auto render = [shared, boom, engine_rpm](const DrillSetting& setting, double seconds,
                                                 std::uint64_t seed) {
    config::Rig seeded = shared->first;
    seeded.engine.seed = seed;
    const auto at = [&](double rpm) {
      return rendered(seeded, shared->second, state_of(setting, boom, rpm), seconds);
    };
    return RenderedSound{at(engine_rpm), engine_rpm > 0 ? at(0) : std::vector<float>()};
  };
  return {plan, render};
}

}  // namespace rigsound::analysis
