#include "loaded_rig.hpp"

#include <fmt/format.h>

#include "rigsound/audio/sample_format.hpp"
#include "rigsound/config/fingerprint.hpp"
#include "rigsound/config/rig_paths.hpp"

namespace rigsound::daemon {
namespace {

template <typename T>
void keep(const char* key, const T& running, T& wanted, std::vector<std::string>& not_applied) {
  if (wanted == running) return;
  not_applied.push_back(fmt::format("{}: {}, wanted {}", key, running, wanted));
  wanted = running;
}

void keep_format(audio::SampleFormat running, audio::SampleFormat& wanted,
                 std::vector<std::string>& not_applied) {
  std::string name(audio::name(wanted));
  keep("audio.format", std::string(audio::name(running)), name, not_applied);
  wanted = running;
}

template <class Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

}  // namespace

LoadedRig build(config::Rig rig) {
  SoundSet sounds = config::load_sounds(rig);
  LoadedRig loaded;
  loaded.sounds = {names_of(sounds.banks), names_of(sounds.rocks)};
  loaded.fingerprint = config::fingerprint(rig);
  loaded.engine = std::make_unique<Engine>(config::build_engine(rig, std::move(sounds)));
  loaded.osc_output = OscOutput(rig.osc);
  loaded.rig = std::move(rig);
  return loaded;
}

LoadedRig load(const std::filesystem::path& file, config::Buses buses) {
  config::Rig rig = config::load_rig(file, buses);
  config::check_paths(rig);
  return build(std::move(rig));
}

LoadedRig load_for_reload(const config::Rig& running, config::Buses buses,
                          std::vector<std::string>& not_applied) {
  config::Rig rig = config::load_rig(running.file, buses);
  keep("audio.device", running.audio.device, rig.audio.device, not_applied);
  keep("audio.rate", running.audio.rate, rig.audio.rate, not_applied);
  keep("audio.block", running.audio.block, rig.audio.block, not_applied);
  keep("audio.periods", running.audio.periods, rig.audio.periods, not_applied);
  keep("audio.channels", running.audio.channels, rig.audio.channels, not_applied);
  keep("audio.resample", running.audio.resample, rig.audio.resample, not_applied);
  keep_format(running.audio.format, rig.audio.format, not_applied);
  keep("control.socket", running.control.socket, rig.control.socket, not_applied);
  keep("control.group", running.control.group, rig.control.group, not_applied);
  keep("control.mode", running.control.mode, rig.control.mode, not_applied);
  keep("control.tcp", running.control.tcp, rig.control.tcp, not_applied);
  keep("control.token_file", running.control.token_file, rig.control.token_file, not_applied);
  keep("control.metrics", running.control.metrics, rig.control.metrics, not_applied);
  rig.engine.sample_rate = running.engine.sample_rate;
  rig.engine.block = running.engine.block;
  rig.engine.channels = running.engine.channels;
  return build(std::move(rig));
}

}  // namespace rigsound::daemon
