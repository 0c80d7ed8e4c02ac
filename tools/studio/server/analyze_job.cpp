#include "analyze_job.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "child_process.hpp"
#include "neighbour.hpp"
#include "rigsound/analysis/labels.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/atomic_folder.hpp"
#include "rigsound/number_of.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;
using analysis::Label;

namespace {

/// The labels of the saved track that `parts` names; all of them without it.
std::vector<Label> chosen_labels(const fs::path& track, const Json& body) {
  constexpr double kSame_s = 0.001;
  std::vector<Label> all = analysis::read_labels(track);
  const auto parts = body.find("parts");
  if (parts == body.end() || parts->is_null()) return all;
  std::vector<Label> chosen;
  for (const Json& part : *parts) {
    const double from = part.at("from_s").get<double>(), to = part.at("to_s").get<double>();
    const auto label = std::find_if(all.begin(), all.end(), [&](const Label& one) {
      return std::fabs(one.start_s - from) < kSame_s && std::fabs(one.end_s - to) < kSame_s;
    });
    if (label == all.end()) throw ApiError(409, "parts: one is not in the saved label track");
    chosen.push_back(*label);
  }
  if (chosen.empty()) throw ApiError(400, "parts: expected at least one");
  return chosen;
}

/// A number where the word is one.
Json value_of(const std::string& word) {
  if (word.empty()) return nullptr;
  const auto number = number_of<double>(word);
  return number && std::isfinite(*number) ? Json(*number) : Json(word);
}

/// "NAME key=value key=value": what analyze prints of a bank. `source` comes last and may hold spaces.
Json bank_of(const std::string& line) {
  constexpr std::string_view kSource = " source=";
  const std::size_t source = line.find(kSource);
  std::istringstream words(line.substr(0, source));
  std::string word;
  words >> word;
  Json bank{{"bank", word}};
  while (words >> word) {
    const std::size_t equals = word.find('=');
    if (equals != std::string::npos) bank[word.substr(0, equals)] = value_of(word.substr(equals + 1));
  }
  if (source != std::string::npos)
    bank["source"] = fs::path(line.substr(source + kSource.size())).filename().string();
  return bank;
}

struct Errand {
  std::vector<std::string> words;  // of the command, without the labels
  std::vector<Label> labels;       // empty: the recording is taken whole
};

/// A track of its own, since the chosen parts may not be all, and the saved one may change meanwhile.
class TrackCopy {
 public:
  explicit TrackCopy(const std::vector<Label>& labels)
      : folder_(fs::temp_directory_path() / "rigsound_studio") {
    if (!labels.empty()) write_file(file(), analysis::labels_text(labels));
  }

  fs::path file() const { return folder_.temporary() / "labels.txt"; }

 private:
  AtomicFolder folder_;  // never put in place: it goes with the job
};

Json run(const Errand& errand, JobControl& control) {
  const TrackCopy track(errand.labels);
  std::vector<std::string> words = errand.words;
  if (!errand.labels.empty()) words.insert(words.end(), {"--labels", track.file().string()});
  const auto child = std::make_shared<ChildProcess>(words);
  control.on_stop([child] { child->stop(); });
  const double parts = std::max<double>(1, static_cast<double>(errand.labels.size()));
  Json banks = Json::array();
  const ChildProcess::Ending ending = child->run([&](const std::string& line) {
    banks.push_back(bank_of(line));
    control.done(banks.back()["bank"].get<std::string>());
    if (!control.stopped()) control.progress(static_cast<double>(banks.size()) / parts);
  });
  control.on_stop(nullptr);
  if (control.stopped()) throw Stopped();
  Json failures = Json::array(), warnings = Json::array();
  const bool gave_less = ending.code == 1 && !banks.empty();
  for (const std::string& line : ending.errors)
    (line.find(": warning: ") != std::string::npos ? warnings : failures).push_back(line);
  if (ending.code != 0 && !gave_less)
    throw DeviceError(ending.code > 128
                          ? "the analysis was killed (signal " + std::to_string(ending.code - 128) + ")"
                      : failures.empty() ? "the analysis failed with code " + std::to_string(ending.code)
                                         : failures.back().get<std::string>());
  return {{"banks", banks}, {"failures", failures}, {"warnings", warnings}};
}

}  // namespace

Jobs::Work analyze_work(Workplace& place, const Json& body) {
  constexpr int kLeastClicks = 2, kMostClicks = 1000;
  const RecordingFile recording = place.recordings.recording(body.at("recording").get<std::string>());
  const fs::path track = place.recordings.labels_of(recording);
  std::error_code none;
  const auto errand = std::make_shared<Errand>();
  errand->words = {tools::neighbour("rigsound").string(),
                   "analyze",
                   recording.file.string(),
                   "--out",
                   place.sound_set.path().string(),
                   "--jobs",
                   std::to_string(place.options.cores)};
  if (fs::exists(track, none)) errand->labels = chosen_labels(track, body);
  if (const auto clicks = body.find("clicks"); clicks != body.end() && !clicks->is_null()) {
    const int count = clicks->get<int>();
    if (count < kLeastClicks || count > kMostClicks) throw ApiError(400, "clicks: expected 2 to 1000");
    errand->words.insert(errand->words.end(), {"--clicks", std::to_string(count)});
  }
  if (const auto method = body.find("method"); method != body.end() && !method->is_null()) {
    const std::string name = method->get<std::string>();
    if (name != "click-nmf" && name != "paper") throw ApiError(400, "method: expected click-nmf or paper");
    errand->words.insert(errand->words.end(), {"--method", name});
  }
  return [errand](JobControl& control) { return run(*errand, control); };
}

}  // namespace rigsound::studio
