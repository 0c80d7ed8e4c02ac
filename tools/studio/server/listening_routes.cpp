#include <ctime>

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "rigsound/config/names.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/input_file.hpp"
#include "routes.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

constexpr const char* kListening = "listening";

std::string time_word() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::ostringstream word;
  word << std::put_time(&utc, "%Y-%m-%dT%H-%M-%SZ");
  return word.str();
}

Answer keep(Workplace& place, const Request& request) {
  const std::string csv = request.object().at("csv").get<std::string>();
  if (csv.empty()) throw ApiError(400, "csv: is empty");
  const std::lock_guard lock(place.writes);
  const fs::path folder = place.sound_set.inside(kListening);
  fs::create_directories(folder);
  const std::string stem = time_word();
  std::string name = stem + ".csv";
  for (int i = 2; fs::exists(folder / name); ++i) name = stem + "_" + std::to_string(i) + ".csv";
  write_file(place.sound_set.inside(fs::path(kListening) / name), csv);
  return json_answer({{"name", name}}, 201);
}

Answer list(const Workplace& place) {
  Json results = Json::array();
  std::error_code none;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(place.sound_set.inside(kListening), none), end; at != end;
       at.increment(none))
    if (at->is_regular_file(none) && at->path().extension() == ".csv" && place.sound_set.holds(at->path()))
      files.push_back(at->path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    results.push_back({{"name", file.filename().string()}, {"bytes", fs::file_size(file, none)}});
  return json_answer({{"results", results}});
}

Answer one(const Workplace& place, const std::string& name) {
  std::error_code none;
  if (!config::is_name(name)) throw ApiError(404, "there is no such result");
  const fs::path file = place.sound_set.inside(fs::path(kListening) / name);
  if (!fs::is_regular_file(file, none)) throw ApiError(404, "there is no such result");
  Answer answer;
  answer.type = "text/csv; charset=utf-8";
  answer.body = InputFile(file, "result", kMostResultBytes).content();
  return answer;
}

}  // namespace

void add_listening_routes(Router& router, Workplace& place) {
  router.add("POST", "/listen/results", [&place](const Request& request) { return keep(place, request); });
  router.add("GET", "/listen/results", [&place](const Request&) { return list(place); });
  router.add("GET", "/listen/results/{}",
             [&place](const Request& request) { return one(place, request.words[0]); });
}

}  // namespace rigsound::studio
