#include <algorithm>
#include <map>
#include <sstream>

#include "packed_rig.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/signal.hpp"
#include "rigsound/number_of.hpp"
#include "routes.hpp"
#include "verb_output.hpp"

namespace rigsound::studio {
namespace {

constexpr std::uintmax_t kMostTableBytes = 64 << 20;
constexpr std::size_t kMostChanges = 200000;

/// CSV time_s,signal,value: of a table itself, or what `decode` makes of a bus log.
std::string states_csv(const Workplace& place, const RecordingFile& log) {
  if (log.file.extension() == ".csv")
    return InputFile(log.file, "table of states", kMostTableBytes).content();
  if (place.options.rig.empty())
    throw ApiError(404, "a bus log is read by a rig: the studio was started without --rig");
  return verb_output({"decode", place.options.rig.string(), "--log", log.file.string()});
}

struct Row {
  double time_s = 0;
  std::string boom, signal, value;
};

/// Nothing for a line that is no row.
std::optional<Row> row_of(const std::string& line) {
  const std::size_t first = line.find(','), second = line.find(',', first + 1);
  const auto time_s = number_of<double>(std::string_view(line).substr(0, first));
  if (second == std::string::npos || !time_s) return std::nullopt;
  Row row;
  row.time_s = *time_s;
  row.signal = line.substr(first + 1, second - first - 1);
  row.value = line.substr(second + 1);
  if (!row.value.empty() && row.value.back() == '\r') row.value.pop_back();
  if (const std::size_t dot = row.signal.find('.'); dot != std::string::npos) {
    row.boom = row.signal.substr(0, dot);
    row.signal.erase(0, dot + 1);
  }
  return row;
}

Json value_json(const std::string& name, const std::string& text) {
  if (const auto number = number_of<double>(text)) return *number;
  const std::optional<Signal> signal = signal_by_name(name);
  const std::optional<double> value = signal ? value_of_word(*signal, text) : std::nullopt;
  return value ? Json(*value) : Json();
}

Json words_json(const std::string& name) {
  const std::optional<Signal> signal = signal_by_name(name);
  return signal ? words_of(info(*signal)) : Json();
}

std::string unit_of(const std::string& name) {
  const std::optional<Signal> signal = signal_by_name(name);
  return signal ? std::string(info(*signal).unit) : "";
}

Json timeline(const RecordingFile& log, const std::string& csv) {
  std::map<std::pair<std::string, std::string>, Json> signals, situations;
  std::istringstream lines(csv);
  std::size_t changes = 0;
  double seconds = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::optional<Row> row = row_of(line);
    if (!row) continue;
    seconds = std::max(seconds, row->time_s);
    if (++changes > kMostChanges) continue;
    const std::pair<std::string, std::string> key{row->boom, row->signal};
    if (row->signal == "situation")
      situations[key].push_back(Json::array({row->time_s, row->value}));
    else
      signals[key].push_back(Json::array({row->time_s, value_json(row->signal, row->value)}));
  }
  if (changes == 0) throw ApiError(422, log.name + ": holds no row time_s,signal,value");
  Json json{{"name", log.name},
            {"seconds", seconds},
            {"signals", Json::array()},
            {"situations", Json::array()},
            {"notes", Json::array()}};
  for (const auto& [key, list] : signals)
    json["signals"].push_back({{"name", key.second},
                               {"boom", key.first},
                               {"unit", unit_of(key.second)},
                               {"words", words_json(key.second)},
                               {"changes", list}});
  for (const auto& [key, list] : situations)
    json["situations"].push_back({{"boom", key.first}, {"changes", list}});
  if (changes > kMostChanges)
    json["notes"].push_back("shows the first " + std::to_string(kMostChanges) + " of " +
                            std::to_string(changes) + " changes");
  return json;
}

}  // namespace

void add_log_routes(Router& router, Workplace& place) {
  router.add("GET", "/logs/{}/timeline", [&place](const Request& request) {
    const RecordingFile log = place.recordings.log(request.words[0]);
    return json_answer(timeline(log, states_csv(place, log)));
  });
  router.add("GET", "/logs/{}/states.csv", [&place](const Request& request) {
    Answer answer;
    answer.type = "text/csv; charset=utf-8";
    answer.body = states_csv(place, place.recordings.log(request.words[0]));
    return answer;
  });
}

}  // namespace rigsound::studio
