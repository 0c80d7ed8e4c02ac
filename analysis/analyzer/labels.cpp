#include "rigsound/analysis/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/number_of.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kMostBytes = 16 << 20;
constexpr std::string_view kGrammar =
    "expected start<TAB>end<TAB>situation [rods=N] [rock=NAME] [rpm=R] [feed=BAR] [percussion=BAR]";
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // some editors write it
constexpr std::string_view kSituations =
    "expected normal, underfeed, overfeed, closed_rattling or open_rattling";

/// Where in which file a value was read: every complaint names it.
struct Place {
  std::string file;
  int line;
  [[noreturn]] void complain(std::string_view key, std::string_view what) const {
    throw InputError(file, line, key, what);
  }
};

constexpr Range kLabelTimes{0, 1e6, "s"}, kLabelRods = Range{1, 20}.whole(), kLabelSpeeds{1, 4000, "r/min"};

double number(const Place& place, std::string_view key, std::string_view text, const Range& range) {
  const auto value = number_of<double>(text);
  if (!value || !std::isfinite(*value))
    place.complain(key, fmt::format("'{}' is no number, expected {}", text, range.text()));
  if (!range.holds(*value)) place.complain(key, range.problem(*value));
  return *value;
}

void set_key(const Place& place, const std::string& word, Label& label) {
  const std::size_t equals = word.find('=');
  const std::string key = word.substr(0, equals),
                    value = equals == std::string::npos ? "" : word.substr(equals + 1);
  if (key == "rods") {
    label.rods = static_cast<int>(number(place, key, value, kLabelRods));
  } else if (key == "rpm") {
    label.rpm = number(place, key, value, kLabelSpeeds);
  } else if (key == "feed" || key == "percussion") {
    const Range& all = config::kRecordedPressures;  // with the 0 of one that was not recorded
    (key == "feed" ? label.feed_bar : label.percussion_bar) =
        number(place, key, value, {all.min, all.max, all.unit});
  } else if (key == "rock") {
    const auto odd = [](unsigned char c) { return !std::isalnum(c) && c != '_' && c != '-' && c != '.'; };
    if (value.empty() || value[0] == '.' || std::any_of(value.begin(), value.end(), odd))
      place.complain(key, fmt::format("'{}' is no name, expected letters, digits, '_', '-' or '.'", value));
    label.rock = value;
  } else {
    place.complain(key, "unknown key, expected rods, rock, rpm, feed or percussion");
  }
}

void set_text(const Place& place, const std::string& text, Label& label) {
  std::istringstream words(text);
  std::string word;
  if (!(words >> word)) place.complain("situation", fmt::format("is missing, {}", kSituations));
  const auto situation = situation_by_name(word);
  if (!situation) place.complain("situation", fmt::format("'{}' is none, {}", word, kSituations));
  label.situation = *situation;
  std::set<std::string> seen;
  while (words >> word) {
    const std::string key = word.substr(0, word.find('='));
    if (!seen.insert(key).second) place.complain(key, "is given twice, expected once");
    set_key(place, word, label);
  }
}

Label parse(const Place& place, const std::string& text) {
  const std::size_t first = text.find('\t');
  const std::size_t second = first == std::string::npos ? first : text.find('\t', first + 1);
  if (second == std::string::npos) place.complain("label", fmt::format("has no two tabs, {}", kGrammar));
  Label label;
  label.line = place.line;
  label.start_s = number(place, "start", std::string_view(text).substr(0, first), kLabelTimes);
  label.end_s =
      number(place, "end", std::string_view(text).substr(first + 1, second - first - 1), kLabelTimes);
  if (!(label.end_s > label.start_s))
    place.complain("end", fmt::format("{} s is not after the start at {} s, expected a stretch of time",
                                      label.end_s, label.start_s));
  set_text(place, text.substr(second + 1), label);
  return label;
}

std::vector<Label> read_track(std::istream& in, const std::string& name) {
  std::vector<Label> labels;
  std::string text;
  for (Place place{name, 1}; std::getline(in, text); ++place.line) {
    if (place.line == 1 && text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0)
      text.erase(0, kByteOrderMark.size());
    if (!text.empty() && text.back() == '\r') text.pop_back();
    if (text.find_first_not_of(" \t") == std::string::npos || text[0] == '\\') continue;
    labels.push_back(parse(place, text));
  }
  if (labels.empty()) throw InputError(name, fmt::format("holds no labels, {}", kGrammar));
  return labels;
}

}  // namespace

std::vector<Label> read_labels(const std::filesystem::path& path) {
  const InputFile input(path, "label file of Audacity", kMostBytes);
  std::ifstream in(input.path());
  return read_track(in, input.name());
}

std::vector<Label> read_labels_text(const std::string& text, const std::string& name) {
  std::istringstream in(text);
  return read_track(in, name);
}

std::string label_words(const Label& label) {
  std::string words(name(label.situation));
  if (label.rods > 0) words += fmt::format(" rods={}", label.rods);
  if (!label.rock.empty()) words += " rock=" + label.rock;
  if (label.rpm > 0) words += fmt::format(" rpm={}", label.rpm);
  if (label.feed_bar > 0) words += fmt::format(" feed={}", label.feed_bar);
  if (label.percussion_bar > 0) words += fmt::format(" percussion={}", label.percussion_bar);
  return words;
}

std::string labels_text(const std::vector<Label>& labels) {
  std::string text;
  for (const Label& label : labels)
    text += fmt::format("{:.6f}\t{:.6f}\t{}\n", label.start_s, label.end_s, label_words(label));
  return text;
}

}  // namespace rigsound::analysis
