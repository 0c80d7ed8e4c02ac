#include <algorithm>
#include <cmath>

#include "rigsound/analysis/labels.hpp"
#include "rigsound/analysis/sound_reader.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "routes.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;
using analysis::Label;

namespace {

constexpr std::size_t kMostTrackBytes = 16 << 20;

Json said(double value) { return value > 0 ? Json(value) : Json(); }

Json part_json(const Label& label) {
  return {{"from_s", label.start_s},
          {"to_s", label.end_s},
          {"text", analysis::label_words(label)},
          {"situation", name(label.situation)},
          {"rods", label.rods > 0 ? Json(label.rods) : Json()},
          {"rock", label.rock.empty() ? Json() : Json(label.rock)},
          {"rpm", said(label.rpm)},
          {"feed", said(label.feed_bar)},
          {"percussion", said(label.percussion_bar)}};
}

/// 0 where the key is null or left out.
double number_or_0(const Json& part, const char* key) {
  const auto found = part.find(key);
  return found == part.end() || found->is_null() ? 0 : found->get<double>();
}

Label label_of(const Json& part) {
  Label label;
  label.start_s = part.at("from_s").get<double>();
  label.end_s = part.at("to_s").get<double>();
  const auto situation = situation_by_name(part.at("situation").get<std::string>());
  if (!situation) throw ApiError(400, "situation: is none");
  label.situation = *situation;
  const double rods = number_or_0(part, "rods");
  if (rods != std::floor(rods) || std::fabs(rods) > 100) throw ApiError(400, "rods: expected a whole number");
  label.rods = static_cast<int>(rods);
  const auto rock = part.find("rock");
  if (rock != part.end() && !rock->is_null()) label.rock = rock->get<std::string>();
  label.rpm = number_or_0(part, "rpm");
  label.feed_bar = number_or_0(part, "feed");
  label.percussion_bar = number_or_0(part, "percussion");
  return label;
}

/// The track as analyze will read it: what it would refuse is refused here. Empty without parts.
std::string track_of(const Json& parts, const fs::path& file, double seconds) {
  std::vector<Label> labels;
  for (const Json& part : parts) labels.push_back(label_of(part));
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.start_s < b.start_s; });
  if (labels.empty()) return "";
  std::string text = analysis::labels_text(labels);
  for (const Label& label : analysis::read_labels_text(text, file.filename().string()))
    if (label.end_s > seconds + analysis::kLabelSlack_s)
      throw ApiError(422, file.filename().string() + ": end: lies behind the end of the recording");
  return text;
}

Json labels_json(const fs::path& file) {
  Json parts = Json::array(), problems = Json::array();
  std::error_code none;
  const bool there = fs::exists(file, none);
  std::string version = kAbsentVersion;
  if (there) {
    const std::string text = InputFile(file, "label track", kMostTrackBytes).content();
    version = version_of_text(text);
    try {
      for (const Label& label : analysis::read_labels_text(text, file.filename().string()))
        parts.push_back(part_json(label));
    } catch (const InputError& error) {
      parts = Json::array();
      problems.push_back(error.what());
    }
  }
  return {{"version", version}, {"parts", parts}, {"problems", problems}};
}

Answer put_labels(Workplace& place, const Request& request) {
  const RecordingFile recording = place.recordings.recording(request.words[0]);
  const fs::path file = place.recordings.labels_of(recording);
  const Json body = request.object();
  const std::string text =
      track_of(body.at("parts"), file, analysis::SoundReader(recording.file).shape().seconds());
  const std::lock_guard lock(place.writes);
  require_version(file, body.at("version").get<std::string>());
  replace_keeping_last(file, text);
  return json_answer(labels_json(file));
}

}  // namespace

void add_label_routes(Router& router, Workplace& place) {
  router.add("GET", "/recordings/{}/labels", [&place](const Request& request) {
    return json_answer(labels_json(place.recordings.labels_of(place.recordings.recording(request.words[0]))));
  });
  router.add("PUT", "/recordings/{}/labels",
             [&place](const Request& request) { return put_labels(place, request); });
}

}  // namespace rigsound::studio
