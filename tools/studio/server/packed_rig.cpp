#include "packed_rig.hpp"

#include <algorithm>

#include "rigsound/config/rig.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
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

/// Their names, in the order in which the signal counts them.
Json rocks_json(const Workplace& place) {
  Json names = Json::array();
  if (version_of(index_of(place)) == kAbsentVersion) return names;
  for (const config::RockEntry& rock : config::load_index(place.sound_set.path()).rocks)
    names.push_back(rock.name);
  return names;
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

EngineOptions engine_of(const Workplace& place) { return rig_file(place).engine; }

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

Json rig_description(const Workplace& place) {
  const EngineOptions engine = engine_of(place);
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
          {"rocks", rocks_json(place)},
          {"signals", signals_json()},
          {"controls", controls_json()}};
}

}  // namespace rigsound::studio
