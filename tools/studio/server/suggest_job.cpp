#include "suggest_job.hpp"

#include "rigsound/analysis/suggestions.hpp"

namespace rigsound::studio {
namespace {

Json suggested_json(const analysis::SuggestedPart& part) {
  Json kinds = Json::array();
  if (part.rate_changed) kinds.push_back("rate");
  if (part.level_changed) kinds.push_back("level");
  if (part.spectrum_changed) kinds.push_back("spectrum");
  return {{"from_s", part.start_s},
          {"to_s", part.end_s},
          {"kinds", kinds},
          {"rhythmic", part.rhythmic},
          {"rate_hz", part.rate_hz > 0 ? Json(part.rate_hz) : Json()},
          {"level_db", part.level_db},
          {"confidence", part.confidence}};
}

}  // namespace

Jobs::Work suggest_work(Workplace& place, const Json& body) {
  const RecordingFile recording = place.recordings.recording(body.at("recording").get<std::string>());
  return [recording](JobControl& control) -> Json {
    analysis::SoundReader sound(recording.file);
    Json parts = Json::array();
    for (const analysis::SuggestedPart& part :
         analysis::suggest_parts(sound, [&control](double share) { control.progress(share); }))
      parts.push_back(suggested_json(part));
    return {{"parts", parts}};
  };
}

}  // namespace rigsound::studio
