#include "sound_set_json.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/config/background_files.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/names.hpp"
#include "rigsound/config/sound_set_index.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

using Problems = std::vector<std::string>;

/// Adds what `make` gives to the list, or why it cannot.
void add(Json& list, Problems& problems, const std::function<Json()>& make) {
  try {
    list.push_back(make());
  } catch (const std::exception& error) {
    problems.emplace_back(error.what());
  }
}

Json bank_json(const Workplace& place, const std::string& name,
               const std::vector<RecordingFile>& recordings) {
  const fs::path folder = bank_folder(place, name);
  const config::StoredBank stored = config::load_bank(folder);
  const ClickBank& bank = stored.bank;
  const analysis::Stretch part = analysis::stretch_of(stored.provenance.settings);
  const RecordingFile* const source = place.recordings.find_source(recordings, stored.provenance.source_file);
  return {{"name", name},
          {"version", bank_version(folder)},
          {"rate_hz", bank.sample_rate / bank.mean_gap_samples},
          {"clicks", bank.clicks.size()},
          {"refined", fs::exists(folder / "refined.json")},
          {"source", fs::path(stored.provenance.source_file).filename().string()},
          {"recording", source == nullptr ? Json() : Json(source->id)},
          {"from_s", part.start_s},
          {"to_s", std::isfinite(part.end_s) ? Json(part.end_s) : Json()}};
}

Json use_json(const config::BankEntry& use) {
  return {{"bank", use.name},      {"situation", name(use.situation)}, {"rods", use.rods},
          {"rock", use.rock},      {"feed_bar", use.feed_bar},         {"percussion_bar", use.percussion_bar},
          {"gain_db", use.gain_db}};
}

Json law_json(const config::LawsEntry& entry) {
  const FeedLaws& laws = entry.laws;
  return {{"rods", laws.rods},
          {"rock", entry.rock},
          {"ln_gap", laws.ln_gap},
          {"ln_level", laws.ln_level},
          {"ln_decay", laws.ln_decay},
          {"gap_variation", laws.gap_variation},
          {"amplitude_variation", laws.amplitude_variation},
          {"tilt_db_per_octave", laws.tilt_db_per_octave}};
}

Json tool_json(const Workplace& place, const config::ToolEntry& tool) {
  return {{"name", tool.name},
          {"kind", tool.kind == config::SteelKind::kString ? "string" : "bar"},
          {"version", version_of(place.sound_set.inside(fs::path("tools") / (tool.name + ".json")))}};
}

Json background_json(const Workplace& place, const std::string& name) {
  Json speeds = Json::array();
  for (const DieselPoint& point :
       config::load_background(place.sound_set.inside(fs::path("backgrounds") / name)).points)
    speeds.push_back(point.rpm);
  return {{"name", name}, {"rpm", speeds}};
}

/// SET/KINDs/NAME, when it is there.
fs::path part_folder(const Workplace& place, const std::string& kind, const std::string& name) {
  std::error_code none;
  const ApiError absent(404, "there is no such " + kind);
  if (!config::is_name(name)) throw absent;
  fs::path folder = place.sound_set.inside(fs::path(kind + "s") / name);
  if (!fs::is_directory(folder, none)) throw absent;
  return folder;
}

}  // namespace

std::string sound_set_name(const Workplace& place) {
  std::error_code none;
  return fs::weakly_canonical(place.sound_set.path(), none).filename().string();
}

fs::path index_of(const Workplace& place) { return place.sound_set.inside("soundset.toml"); }

fs::path bank_folder(const Workplace& place, const std::string& name) {
  fs::path folder = part_folder(place, "bank", name);
  for (const char* file : {"bank.json", "clicks.wav", "refined.json"})
    place.sound_set.inside(fs::path("banks") / name / file);
  return folder;
}

fs::path background_folder(const Workplace& place, const std::string& name) {
  std::error_code none;
  fs::path folder = part_folder(place, "background", name);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
    place.sound_set.inside(fs::path("backgrounds") / name / entry.path().filename());
  return folder;
}

std::string bank_version(const fs::path& folder) {
  return version_of_text(version_of(folder / "bank.json") + version_of(folder / "clicks.wav") +
                         version_of(folder / "refined.json"));
}

Json sound_set_json(const Workplace& place) {
  Json json{{"version", version_of(index_of(place))}, {"name", sound_set_name(place)}};
  for (const char* list : {"banks", "uses", "rocks", "tools", "backgrounds", "laws"})
    json[list] = Json::array();
  Problems problems;
  try {
    const config::SoundSetIndex index = json["version"] == kAbsentVersion
                                            ? config::SoundSetIndex()
                                            : config::load_index(place.sound_set.path());
    const std::vector<RecordingFile> recordings = place.recordings.recordings();
    std::vector<std::string> seen;
    for (const config::BankEntry& use : index.banks) {
      json["uses"].push_back(use_json(use));
      if (std::find(seen.begin(), seen.end(), use.name) != seen.end()) continue;
      seen.push_back(use.name);
      add(json["banks"], problems, [&] { return bank_json(place, use.name, recordings); });
    }
    for (const config::RockEntry& rock : index.rocks)
      json["rocks"].push_back({{"name", rock.name}, {"stiffness", rock.stiffness}});
    for (const config::ToolEntry& tool : index.tools)
      add(json["tools"], problems, [&] { return tool_json(place, tool); });
    for (const std::string& background : index.backgrounds)
      add(json["backgrounds"], problems, [&] { return background_json(place, background); });
    for (const config::LawsEntry& laws : index.laws) json["laws"].push_back(law_json(laws));
  } catch (const std::exception& error) {
    problems.emplace_back(error.what());
  }
  json["problems"] = problems;
  return json;
}

}  // namespace rigsound::studio
