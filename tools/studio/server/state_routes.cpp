#include <system_error>

#include "rigsound/analysis/sound_reader.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/machine/input_error.hpp"
#include "routes.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

Json recording_json(const Workplace& place, const RecordingFile& file) {
  const analysis::SoundShape shape = analysis::SoundReader(file.file).shape();
  std::error_code none;
  return {{"id", file.id},
          {"name", file.name},
          {"frames", shape.frames},
          {"rate", shape.rate},
          {"channels", shape.channels},
          {"seconds", shape.seconds()},
          {"hash", file.hash},
          {"labels", fs::exists(fs::path(file.file).replace_extension(".txt"), none) &&
                         fs::exists(place.recordings.labels_of(file), none)}};
}

Json rig_json(const fs::path& file, std::vector<std::string>& problems) {
  if (file.empty()) return nullptr;
  Json booms = Json::array();
  try {
    const config::Rig rig = config::load_rig(file, config::Buses::kLeftOut);
    for (const BoomOptions& boom : rig.engine.booms) booms.push_back(boom.name);
  } catch (const InputError& error) {
    problems.emplace_back(error.what());
  }
  return {{"name", file.filename().string()}, {"booms", booms}};
}

Answer state(const Workplace& place) {
  std::vector<std::string> problems;
  Json recordings = Json::array(), logs = Json::array();
  for (const RecordingFile& file : place.recordings.recordings()) try {
      recordings.push_back(recording_json(place, file));
    } catch (const std::exception& error) {
      problems.emplace_back(error.what());
    }
  for (const RecordingFile& file : place.recordings.logs())
    logs.push_back({{"id", file.id}, {"name", file.name}});
  const StudioOptions& options = place.options;
  return json_answer(
      {{"version", options.version},
       {"sound_set", {{"name", sound_set_name(place)}, {"version", version_of(index_of(place))}}},
       {"rig", rig_json(options.rig, problems)},
       {"recordings", recordings},
       {"logs", logs},
       {"daemon", !options.daemon.empty()},
       {"writable", place.sound_set.writable()},
       {"cores", options.cores},
       {"problems", problems}});
}

}  // namespace

void add_state_routes(Router& router, Workplace& place) {
  router.add("GET", "/state", [&place](const Request&) { return state(place); });
}

}  // namespace rigsound::studio
