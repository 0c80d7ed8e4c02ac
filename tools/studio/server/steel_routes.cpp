#include <algorithm>
#include <stdexcept>

#include "packed_part.hpp"
#include "packed_rig.hpp"
#include "rigsound/config/names.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/file/input_file.hpp"
#include "routes.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostToolBytes = 4 << 20;

/// The numbers of a list of fields with what they may be.
struct NumberRanges {
  Json& json;
  void operator()(const char* key, const double& value, const Range& range) {
    json[key] = {{"value", value}, {"min", range.min}, {"max", range.max}, {"unit", range.unit}};
  }
};

template <class Options>
Json ranges_of(const Options& options) {
  Json json;
  NumberRanges ranges{json};
  visit(ranges, options);
  return json;
}

DecayWish wish_of(const Json& body, const char* key) {
  const auto wish = body.find(key);
  if (wish == body.end() || wish->is_null()) return {};
  const auto number = [&](const char* part) { return wish->at(part).get<double>(); };
  return {number("low_hz"), number("low_s"), number("high_hz"), number("high_s")};
}

/// The steel that `body` asks for, with its design at the rig's rate. Errors: ApiError 422 when there is
/// none.
ToolModel steel_of(const Workplace& place, const Json& body, const std::string& name) {
  ToolModel steel;
  steel.name = name;
  steel.bar = {body.at("length_m").get<double>(), body.at("diameter_m").get<double>()};
  steel.transversal.wish = wish_of(body, "transversal");
  steel.longitudinal.wish = wish_of(body, "longitudinal");
  try {
    steel.designs = {design_tool(steel, engine_of(place).sample_rate)};
  } catch (const std::invalid_argument& error) {
    throw ApiError(422, error.what());
  }
  return steel;
}

Answer tune(const Workplace& place, const Request& request) {
  const ToolModel steel = steel_of(place, request.object(), "steel");
  Json list = Json::array();
  for (const TunedMode& mode : tuned_modes(steel, steel.designs.front()))
    list.push_back({{"family", mode.family},
                    {"mode", mode.mode},
                    {"target_hz", mode.target_hz},
                    {"model_hz", mode.model_hz},
                    {"error_cents", mode.error_cents},
                    {"t60_s", mode.t60_s}});
  return json_answer({{"modes", list}});
}

Answer rigset_of_steel(const Workplace& place, const Request& request) {
  const Json body = request.object();
  const Hammer hammer{body.value("bank", std::string()), body.value("clicks", false)};
  return bytes_answer(packed_steel(place, steel_of(place, body, "steel"), hammer));
}

fs::path tool_file(const Workplace& place, const std::string& name) {
  if (!config::is_name(name)) throw ApiError(404, "there is no such tool");
  return place.sound_set.inside(fs::path("tools") / (name + ".json"));
}

/// What is kept of a tool may be a link too.
void require_inside(const Workplace& place, const std::string& name) {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(place.sound_set.path() / "tools", none))
    if (entry.path().stem() == name + ".json") place.sound_set.inside("tools" / entry.path().filename());
}

Json saved_json(const std::string& name, const fs::path& file) {
  return {{"name", name}, {"version", version_of(file)}};
}

/// A name that soundset.toml knows as a drill string's cannot become a bar's.
void require_bar(const Workplace& place, const std::string& name) {
  if (version_of(index_of(place)) == kAbsentVersion) return;
  for (const config::ToolEntry& tool : config::load_index(place.sound_set.path()).tools)
    if (tool.name == name && tool.kind != config::SteelKind::kBar)
      throw ApiError(422, name + ": is a drill string, expected another name");
}

Answer put_tool(Workplace& place, const Request& request) {
  const std::string& name = request.words[0];
  const fs::path file = tool_file(place, name);
  const Json body = request.object();
  const ToolModel steel = steel_of(place, body, name);
  const std::lock_guard lock(place.writes);
  require_bar(place, name);
  require_version(file, body.at("version").get<std::string>());
  config::save_tool(place.sound_set.path(), steel);
  config::SoundSetIndex index;
  index.tools = {{name}};
  config::merge_index(place.sound_set.path(), index);
  return json_answer(saved_json(name, file));
}

Answer restore_tool(Workplace& place, const Request& request) {
  const std::string& name = request.words[0];
  const fs::path file = tool_file(place, name);
  const std::string seen = request.object().at("version").get<std::string>();
  const std::lock_guard lock(place.writes);
  require_inside(place, name);
  require_version(file, seen);
  if (!config::restore_tool(place.sound_set.path(), name))
    throw ApiError(404, name + ": nothing was put aside");
  return json_answer(saved_json(name, file));
}

Answer get_tool(const Workplace& place, const std::string& name) {
  const fs::path file = tool_file(place, name);
  std::error_code none;
  if (!fs::is_regular_file(file, none)) throw ApiError(404, "there is no such tool");
  Json tool = config::parsed_json(InputFile(file, "tool", kMostToolBytes).content());
  if (!tool.is_object()) throw ApiError(422, file.filename().string() + ": is no JSON object");
  Json json = saved_json(name, file);
  json["tool"] = tool;
  return json_answer(json);
}

}  // namespace

void add_steel_routes(Router& router, Workplace& place) {
  router.add("GET", "/steel", [](const Request&) {
    return json_answer({{"bar", ranges_of(Bar())}, {"decay", ranges_of(DecayWish())}});
  });
  router.add("POST", "/steel", [&place](const Request& request) { return tune(place, request); });
  router.add("POST", "/steel/rigset",
             [&place](const Request& request) { return rigset_of_steel(place, request); });
  router.add("GET", "/tools/{}",
             [&place](const Request& request) { return get_tool(place, request.words[0]); });
  router.add("PUT", "/tools/{}", [&place](const Request& request) { return put_tool(place, request); });
  router.add("POST", "/tools/{}/restore",
             [&place](const Request& request) { return restore_tool(place, request); });
}

}  // namespace rigsound::studio
