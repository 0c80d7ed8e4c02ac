#include <algorithm>
#include <cmath>

#include "rigsound/analysis/diesel_spectrum.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/config/background_files.hpp"
#include "rigsound/machine/signal.hpp"
#include "rigsound/number_of.hpp"
#include "routes.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

DieselModel diesel_of(const Workplace& place, const std::string& name) {
  return config::load_background(background_folder(place, name));
}

/// The recording at one speed that a point was learned from; nothing where it is not in the folder, or is a
/// run-up with several points.
const RecordingFile* recording_of(const Workplace& place, const DieselModel& model, const DieselPoint& point,
                                  const std::vector<RecordingFile>& all) {
  const auto of_it = std::count_if(model.points.begin(), model.points.end(),
                                   [&](const DieselPoint& other) { return other.source == point.source; });
  return of_it == 1 ? place.recordings.find_source(all, point.source) : nullptr;
}

Answer diesel(const Workplace& place, const std::string& name) {
  const DieselModel model = diesel_of(place, name);
  const std::vector<RecordingFile> all = place.recordings.recordings();
  Json points = Json::array();
  for (const DieselPoint& point : model.points) {
    const RecordingFile* const file = recording_of(place, model, point, all);
    points.push_back({{"rpm", point.rpm},
                      {"load", point.load},
                      {"source", fs::path(point.source).filename().string()},
                      {"recording", file == nullptr ? Json() : Json(file->id)}});
  }
  return json_answer({{"name", name}, {"points", points}});
}

/// Two decimals: thousands of them go to the page at every move of a slider.
Json short_numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(std::round(100 * value) / 100);
  return list;
}

Json spectrum_json(const analysis::DieselSpectrum& s) {
  Json orders = Json::array();
  for (std::size_t k = 0; k < s.orders.x.size(); ++k)
    orders.push_back({{"order", 0.5 * static_cast<double>(k + 1)},  // a cycle is two turns
                      {"hz", s.orders.x[k]},
                      {"db", s.orders.y[k]}});
  return {{"rpm", s.rpm},
          {"spectrum", {{"hz", short_numbers(s.bands.x)}, {"db", short_numbers(s.bands.y)}}},
          {"orders", orders}};
}

double asked_number(const Request& request, const char* name, const Range& range) {
  const double value = request.number(name, 0);
  if (!range.holds(value)) throw ApiError(400, std::string(name) + ": " + range.problem(value));
  return value;
}

Answer modelled(const Workplace& place, const Request& request) {
  const double rpm = asked_number(request, "rpm", analysis::kSpectrumSpeeds),
               load = asked_number(request, "load", info(Signal::kEngineLoad).range());
  Json json = spectrum_json(analysis::modelled_spectrum(diesel_of(place, request.words[0]), rpm, load));
  json["load"] = load;
  return json_answer(json);
}

std::size_t point_index(const std::string& word, std::size_t count) {
  const auto index = number_of<std::size_t>(word);
  if (!index || *index >= count) throw ApiError(404, "there is no such point");
  return *index;
}

Answer recorded(const Workplace& place, const Request& request) {
  const DieselModel model = diesel_of(place, request.words[0]);
  const DieselPoint& point = model.points[point_index(request.words[1], model.points.size())];
  const std::vector<RecordingFile> all = place.recordings.recordings();
  const RecordingFile* const file = recording_of(place, model, point, all);
  if (file == nullptr) throw ApiError(404, "its recording is not in the folder of recordings");
  analysis::Stretch heard;
  analysis::Recording recording = analysis::read_recording(
      file->file, [&](double length_s) { return heard = analysis::learned_stretch(length_s, {}); }, "engine");
  analysis::DieselTake take;
  take.source = file->name;
  take.source_rate = recording.source_rate;
  take.rpm = point.rpm;
  const double length_s = static_cast<double>(recording.mono.size()) / analysis::kAnalysisRate;
  take.mono = std::move(recording.mono);
  Json json = spectrum_json(analysis::recorded_spectrum(take, model.angle_samples));
  json["recording"] = file->id;
  json["from_s"] = heard.start_s;
  json["to_s"] = heard.start_s + length_s;
  return json_answer(json);
}

}  // namespace

void add_diesel_routes(Router& router, Workplace& place) {
  router.add("GET", "/diesel/{}", [&place](const Request& r) { return diesel(place, r.words[0]); });
  router.add("GET", "/diesel/{}/spectrum", [&place](const Request& r) { return modelled(place, r); });
  router.add("GET", "/diesel/{}/recorded/{}", [&place](const Request& r) { return recorded(place, r); });
}

}  // namespace rigsound::studio
