#include <algorithm>

#include "routes.hpp"
#include "sound_set_json.hpp"
#include "trial_sounds.hpp"

namespace rigsound::studio {
namespace {

constexpr Range kTrialStarts{0, 3600, "s"}, kTrialLengths{1, 20, "s"};

double seconds_of(const Json& body, const char* key, double otherwise, const Range& range) {
  const double value = body.value(key, otherwise);
  if (!range.holds(value)) throw ApiError(400, std::string(key) + ": " + range.problem(value));
  return value;
}

/// The two that an ABX test is about.
std::vector<std::string> pair_of(const Json& body) {
  std::vector<std::string> pair = body.at("pair").get<std::vector<std::string>>();
  const std::vector<std::string>& known = trial_kinds();
  const bool fits = pair.size() == 2 && pair[0] != pair[1] &&
                    std::all_of(pair.begin(), pair.end(), [&](const std::string& kind) {
                      return std::find(known.begin(), known.end(), kind) != known.end();
                    });
  if (!fits) throw ApiError(400, "pair: expected two of recorded, denoised, synthesised, anchor");
  return pair;
}

Answer open_trial(Workplace& place, const Request& request) {
  const Json body = request.object();
  ListeningTrial trial;
  trial.test = body.at("test").get<std::string>();
  trial.bank = body.at("bank").get<std::string>();
  const bool abx = trial.test == "abx";
  if (!abx && trial.test != "rating") throw ApiError(400, "test: expected abx or rating");
  bank_folder(place, trial.bank);  // before anything else is made of the name
  TrialRequest wanted{trial.bank, abx ? pair_of(body) : trial_kinds(),
                      seconds_of(body, "from_s", 0, kTrialStarts),
                      seconds_of(body, "seconds", 5, kTrialLengths)};
  TrialSounds made = trial_sounds(place, wanted);
  trial.seconds = made.seconds;
  trial.waves = std::move(made.waves);
  trial.gains_db = std::move(made.gains_db);
  trial.sounds = abx ? abx_places(wanted.kinds) : rating_places(wanted.kinds);
  Json places = Json::array();
  for (const auto& [name, kind] : trial.sounds) places.push_back(name);
  const double seconds = trial.seconds;
  return json_answer({{"id", place.trials.open(std::move(trial))}, {"seconds", seconds}, {"sounds", places}},
                     201);
}

Answer end_trial(Workplace& place, const std::string& id) {
  const ListeningTrial trial = place.trials.end(id);
  Json sounds = Json::object(), gains_db = Json::object();
  for (const auto& [name, kind] : trial.sounds) sounds[name] = kind;
  for (const auto& [kind, gain_db] : trial.gains_db) gains_db[kind] = gain_db;
  return json_answer({{"id", trial.id},
                      {"test", trial.test},
                      {"bank", trial.bank},
                      {"sounds", sounds},
                      {"gain_db", gains_db}});
}

}  // namespace

void add_trial_routes(Router& router, Workplace& place) {
  router.add("POST", "/listen/trials", [&place](const Request& r) { return open_trial(place, r); });
  router.add("GET", "/listen/trials/{}/sounds/{}",
             [&place](const Request& r) { return wave_answer(place.trials.wave(r.words[0], r.words[1])); });
  router.add("DELETE", "/listen/trials/{}",
             [&place](const Request& r) { return end_trial(place, r.words[0]); });
}

}  // namespace rigsound::studio
