#include <algorithm>
#include <cmath>
#include <sstream>

#include "bank_sounds.hpp"
#include "rigsound/analysis/resynth.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/config/refinement.hpp"
#include "rigsound/file/input_file.hpp"
#include "routes.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;
using analysis::Curve, analysis::RecordedSide;

namespace {

constexpr double kMostHeard_s = 60;

/// Infinite and undefined ones have no number in JSON.
Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number_or_null(value));
  return list;
}

Json histogram_json(const analysis::Histogram& histogram, const char* unit) {
  return {{"unit", unit},
          {"edges", numbers(histogram.edges)},
          {"share", numbers(histogram.share)},
          {"engine", {{"x", numbers(histogram.engine.x)}, {"y", numbers(histogram.engine.y)}}}};
}

Json statistics_json(const ClickBank& bank) {
  const double ms = 1e3 / bank.sample_rate;
  return {{"gap_ms", bank.mean_gap_samples * ms},
          {"gap_deviation_ms", bank.gap_deviation_samples * ms},
          {"gap_correlation", bank.gap_correlation},
          {"miss_share", bank.miss_share},
          {"double_share", bank.double_share},
          {"amplitude", bank.mean_amplitude},
          {"amplitude_deviation", bank.amplitude_deviation},
          {"amplitude_correlation", bank.amplitude_correlation},
          {"attack_ms", bank.attack_samples * ms},
          {"decay_db_per_ms", bank.decay * 20 / std::log(10.0) / ms}};
}

Json refinement_json(const fs::path& folder) {
  const config::Refinement refinement = config::load_refinement(folder).value_or(config::Refinement());
  Json controls;
  for (const ControlInfo& control : control_table())
    controls[std::string(control.name)] = static_cast<double>(refinement.controls.*control.field);
  return {{"version", version_of(folder / config::kRefinementFile)},
          {"controls", controls},
          {"dropped", refinement.dropped},
          {"trim_db", refinement.trim_db}};
}

Json clicks_json(const ClickBank& analysed, const std::vector<int>& dropped) {
  Json list = Json::array();
  for (std::size_t c = 0; c < analysed.clicks.size(); ++c)
    list.push_back(
        {{"index", c},
         {"samples", analysed.clicks[c].size()},
         {"dropped", std::find(dropped.begin(), dropped.end(), static_cast<int>(c)) != dropped.end()}});
  return list;
}

/// What analyze wrote beside the bank; null for banks from elsewhere.
Json figures_json(const fs::path& folder) {
  constexpr std::uintmax_t kMostBytes = 1 << 16;
  const fs::path file = folder / "figures.json";
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return nullptr;
  Json figures = config::parsed_json(InputFile(file, "figures", kMostBytes).content());
  return figures.is_object() ? figures : Json();
}

/// The curves of recorded and denoised (null without a recording) beside the synthesised.
Json spectra_json(const char* place, const Curve& synthesised, const Curve* recorded, const Curve* denoised,
                  const Curve* target) {
  const auto levels = [](const Curve* curve) { return curve == nullptr ? Json() : numbers(curve->y); };
  Json json{{place, numbers(synthesised.x)},
            {"recorded_db", levels(recorded)},
            {"denoised_db", levels(denoised)},
            {"synthesised_db", numbers(synthesised.y)}};
  if (target != nullptr) json["target_db"] = numbers(target->y);
  return json;
}

Json bank_json(Workplace& place, const std::string& name) {
  const fs::path folder = bank_folder(place, name);
  const config::StoredBank analysed = config::load_analysed_bank(folder), played = config::load_bank(folder);
  std::shared_ptr<const RecordedSide> side;
  Json warnings = Json::array();
  try {
    side = place.comparisons.of(analysed);
  } catch (const std::exception& error) {
    warnings.push_back(error.what());
  }
  const analysis::SoundSpectra synthesised =
      analysis::spectra_of(analysis::resynthesise(played.bank, kSynthesis_s, kSynthesisSeed).sound);
  const Json refinement = refinement_json(folder);
  const ClickBank& bank = analysed.bank;
  const bool heard = side != nullptr;
  return {
      {"name", name},
      {"version", bank_version(folder)},
      {"figures", figures_json(folder)},
      {"warnings", warnings},
      {"statistics", statistics_json(bank)},
      {"gaps", heard && !side->gaps_ms.empty()
                   ? histogram_json(analysis::gap_histogram(side->gaps_ms, played.bank), "ms")
                   : Json()},
      {"amplitudes", heard && !side->amplitudes.empty()
                         ? histogram_json(analysis::amplitude_histogram(side->amplitudes, played.bank), "")
                         : Json()},
      {"third_octaves",
       spectra_json("centre_hz", synthesised.third_octaves,
                    heard ? &side->of_recorded.third_octaves : nullptr,
                    heard ? &side->of_denoised.third_octaves : nullptr, heard ? &side->target : nullptr)},
      {"modulation",
       spectra_json("hz", synthesised.modulation, heard ? &side->of_recorded.modulation : nullptr,
                    heard ? &side->of_denoised.modulation : nullptr, nullptr)},
      {"envelope",
       {{"rate", bank.sample_rate},
        {"attack_samples", bank.attack_samples},
        {"attack_bend", bank.attack_bend},
        {"decay", bank.decay}}},
      {"clicks", clicks_json(bank, refinement["dropped"].get<std::vector<int>>())},
      {"refinement", refinement}};
}

Answer sound(Workplace& place, const std::string& name, const std::string& which) {
  const BankSound found = bank_sound(place, name, which, kMostHeard_s);
  return wave_answer(analysis::wave_bytes(found.samples, found.rate));
}

Answer click(const Workplace& place, const std::string& name, const std::string& index) {
  constexpr float kPeak = 0.5F;
  const ClickBank bank = config::load_analysed_bank(bank_folder(place, name)).bank;
  for (std::size_t c = 0; c < bank.clicks.size(); ++c) {
    if (std::to_string(c) != index) continue;
    std::vector<float> x(bank.clicks[c].begin(), bank.clicks[c].end());
    float peak = 0;
    for (const float value : x) peak = std::max(peak, std::fabs(value));
    for (float& value : x) value *= peak > 0 ? kPeak / peak : 0;
    return wave_answer(analysis::wave_bytes(x, static_cast<int>(std::lround(bank.sample_rate))));
  }
  throw ApiError(404, "there is no such click");
}

config::Refinement refinement_of(const Json& body) {
  config::Refinement refinement;
  const Json controls = body.value("controls", Json::object());
  for (const auto& item : controls.items()) {
    const std::string& key = item.key();
    const auto control = std::find_if(control_table().begin(), control_table().end(),
                                      [&](const ControlInfo& info) { return info.name == key; });
    if (control == control_table().end()) throw ApiError(400, "controls: " + key + " is none");
    const double value = item.value().get<double>();
    if (!control->takes(value)) throw ApiError(400, key + ": " + control->range().problem(value));
    refinement.controls.*control->field = static_cast<float>(value);
  }
  refinement.dropped = body.value("dropped", std::vector<int>());
  std::sort(refinement.dropped.begin(), refinement.dropped.end());
  refinement.trim_db = body.value("trim_db", 0.0);
  if (!config::kRefinementTrims.holds(refinement.trim_db))
    throw ApiError(400, "trim_db: " + config::kRefinementTrims.problem(refinement.trim_db));
  return refinement;
}

Answer put_refinement(Workplace& place, const Request& request) {
  const fs::path folder = bank_folder(place, request.words[0]);
  const Json body = request.object();
  const config::Refinement refinement = refinement_of(body);
  config::refined(config::load_analysed_bank(folder).bank,
                  refinement);  // what could not be played is refused
  const std::lock_guard lock(place.writes);
  require_version(folder / config::kRefinementFile, body.at("version").get<std::string>());
  replace_keeping_last(folder / config::kRefinementFile, config::refinement_text(refinement));
  return json_answer(refinement_json(folder));
}

Answer delete_refinement(Workplace& place, const Request& request) {
  const fs::path folder = bank_folder(place, request.words[0]);
  const auto version = request.query.find("version");
  if (version == request.query.end()) throw ApiError(400, "version: is missing");
  const std::lock_guard lock(place.writes);
  require_version(folder / config::kRefinementFile, version->second);
  replace_keeping_last(folder / config::kRefinementFile, "");
  return json_answer(refinement_json(folder));
}

}  // namespace

void add_bank_routes(Router& router, Workplace& place) {
  router.add("GET", "/banks/{}",
             [&place](const Request& r) { return json_answer(bank_json(place, r.words[0])); });
  router.add("GET", "/banks/{}/sound/{}",
             [&place](const Request& r) { return sound(place, r.words[0], r.words[1]); });
  router.add("GET", "/banks/{}/clicks/{}",
             [&place](const Request& r) { return click(place, r.words[0], r.words[1]); });
  router.add("PUT", "/banks/{}/refinement", [&place](const Request& r) { return put_refinement(place, r); });
  router.add("DELETE", "/banks/{}/refinement",
             [&place](const Request& r) { return delete_refinement(place, r); });
}

}  // namespace rigsound::studio
