#include "rigsound/file/input_file.hpp"
#include "routes.hpp"
#include "sound_set_json.hpp"
#include "verb_output.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostToolBytes = 4 << 20;

std::string exact(double value) { return Json(value).dump(); }

void add_decay(const Json& body, const char* key, const std::string& option,
               std::vector<std::string>& words) {
  const auto decay = body.find(key);
  if (decay == body.end() || decay->is_null()) return;
  words.push_back(option);
  for (const char* part : {"low_hz", "low_s", "high_hz", "high_s"})
    words.push_back(exact(decay->at(part).get<double>()));
}

/// `rigsound tool` for the steel that `body` asks for.
std::vector<std::string> tool_words(const Json& body) {
  std::vector<std::string> words = {"tool",
                                    "--length",
                                    exact(body.at("length_m").get<double>()),
                                    "--diameter",
                                    exact(body.at("diameter_m").get<double>()),
                                    "--json"};
  add_decay(body, "transversal", "--t60-transversal", words);
  add_decay(body, "longitudinal", "--t60-longitudinal", words);
  return words;
}

fs::path tool_file(const Workplace& place, const std::string& name) {
  if (!is_name(name)) throw ApiError(404, "there is no such tool");
  return place.sound_set.inside(fs::path("tools") / (name + ".json"));
}

Answer put_tool(Workplace& place, const Request& request) {
  const std::string& name = request.words[0];
  const fs::path file = tool_file(place, name);
  const Json body = request.object();
  std::vector<std::string> words = tool_words(body);
  words.insert(words.end(), {"--name", name, "--out", place.sound_set.path().string()});
  const std::lock_guard lock(place.writes);
  require_version(file, body.at("version").get<std::string>());
  verb_output(words);
  return json_answer({{"name", name}, {"version", version_of(file)}});
}

Answer get_tool(const Workplace& place, const std::string& name) {
  const fs::path file = tool_file(place, name);
  std::error_code none;
  if (!fs::is_regular_file(file, none)) throw ApiError(404, "there is no such tool");
  Json tool = Json::parse(InputFile(file, "tool", kMostToolBytes).content(), nullptr, false);
  if (!tool.is_object()) throw ApiError(422, file.filename().string() + ": is no JSON object");
  return json_answer({{"name", name}, {"version", version_of(file)}, {"tool", tool}});
}

}  // namespace

void add_steel_routes(Router& router, Workplace& place) {
  router.add("POST", "/steel", [](const Request& request) {
    return json_answer(Json::parse(verb_output(tool_words(request.object()))));
  });
  router.add("GET", "/tools/{}",
             [&place](const Request& request) { return get_tool(place, request.words[0]); });
  router.add("PUT", "/tools/{}", [&place](const Request& request) { return put_tool(place, request); });
}

}  // namespace rigsound::studio
