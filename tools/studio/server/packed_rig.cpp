#include "packed_rig.hpp"

#include <algorithm>

#include "rigsound/config/refinement.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/feed_rule.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {
namespace {

config::Rig rig_file(const Workplace& place) {
  return place.options.rig.empty() ? config::Rig()
                                   : config::load_rig(place.options.rig, config::Buses::kLeftOut);
}

Json signals_json() {
  Json list = Json::array();
  for (const SignalInfo& signal : signal_table())
    list.push_back({{"name", signal.name},
                    {"unit", signal.unit},
                    {"min", signal.min},
                    {"max", signal.max},
                    {"absent", signal.absent},
                    {"words", words_of(signal)},
                    {"per_boom", signal.per_boom},
                    {"meaning", signal.meaning}});
  return list;
}

Json controls_json() {
  Json list = Json::array();
  for (const ControlInfo& control : control_table())
    list.push_back({{"name", control.name},
                    {"unit", control.unit},
                    {"min", control.min},
                    {"max", control.max},
                    {"neutral", control.neutral},
                    {"meaning", control.meaning}});
  return list;
}

/// Of a bank alone: nothing else sounds.
config::SoundSetParts parts_of(config::StoredBank stored) {
  config::SoundSetParts parts;
  for (int s = 0; s < kSituationCount; ++s) {
    config::BankEntry use;
    use.name = stored.bank.name;
    use.situation = static_cast<Situation>(s);
    parts.index.banks.push_back(use);
  }
  parts.index.rocks = {{"medium"}};
  parts.banks.push_back(std::move(stored));
  return parts;
}

}  // namespace

Json words_of(const SignalInfo& signal) {
  if (signal.words.empty()) return nullptr;
  Json words = Json::array();
  for (std::size_t from = 0; from <= signal.words.size();) {
    const std::size_t to = std::min(signal.words.find('|', from), signal.words.size());
    words.push_back(signal.words.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

config::PackedRig rig_of(const Workplace& place, const config::SoundSetParts& parts) {
  const config::Rig rig = rig_file(place);
  config::PackedRig packed{rig.engine, rig.boom_tools};
  if (place.options.rig.empty()) packed.boom_tools = {parts.tools.empty() ? "" : parts.tools.front().name};
  return packed;
}

std::string packed_sound_set(const Workplace& place, PackRig rig) {
  config::PackedSet set;
  set.parts = config::load_sound_set(place.sound_set.path());
  if (rig == PackRig::kEmbedded) {
    set.rig = rig_of(place, set.parts);
    config::SoundingRig sounding = config::rig_of(set, place.sound_set.path());
    config::build_engine(sounding, config::sounds_of(sounding, set.parts));
  }
  return config::packed(set);
}

std::string packed_bank(const Workplace& place, const std::string& name, const std::vector<int>& clicks) {
  config::StoredBank stored = config::load_analysed_bank(bank_folder(place, name));
  if (!clicks.empty()) {
    std::vector<Click> kept;
    for (const int click : clicks) {
      if (click < 0 || click >= static_cast<int>(stored.bank.clicks.size()))
        throw ApiError(400, "clicks: there is no click " + std::to_string(click));
      kept.push_back(stored.bank.clicks[static_cast<std::size_t>(click)]);
    }
    stored.bank.clicks = std::move(kept);
  }
  config::PackedSet set;
  set.parts = parts_of(std::move(stored));
  set.rig = config::PackedRig{rig_file(place).engine, {}};
  set.rig->engine.booms.resize(1);
  set.rig->engine.booms.front() = BoomOptions();
  set.rig->boom_tools = {""};
  return config::packed(set);
}

Json rig_description(const Workplace& place) {
  const EngineOptions engine = rig_file(place).engine;
  Json booms = Json::array();
  for (const BoomOptions& boom : engine.booms) booms.push_back(boom.name);
  const SceneOptions& scene = engine.scene;
  return {{"rate", engine.sample_rate},
          {"block", engine.block},
          {"channels", engine.channels},
          {"booms", booms},
          {"seed", engine.seed},
          {"feed",
           {{"contact_bar", scene.contact_bar},
            {"underfeed_bar", scene.underfeed_bar},
            {"overfeed_bar", scene.overfeed_bar},
            {"normal_bar", scene::feed_points(scene).normal},
            {"largest_bar", kFeedPressures.max}}},
          {"idle_rpm", scene.idle_rpm},
          {"signals", signals_json()},
          {"controls", controls_json()}};
}

}  // namespace rigsound::studio
