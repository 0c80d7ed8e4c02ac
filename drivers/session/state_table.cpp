#include "rigsound/session/state_table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/number_of.hpp"
#include "rigsound/session/state_rows.hpp"

namespace rigsound::session {
namespace {

const std::string kHeading = "time_s,signal,value";

struct Line {
  std::string file;
  int number;

  [[noreturn]] void fail(std::string_view key, const std::string& message) const {
    throw InputError(file, number, key, message);
  }
};

std::optional<double> number_in(const std::string& text) {
  const auto value = number_of<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

Signal signal_of(const std::string& name, const Line& line) {
  if (const auto known = signal_by_name(name)) return *known;
  std::string names;
  for (const SignalInfo& signal : signal_table()) append_to_list(names, signal.name);
  line.fail("signal", "'" + name + "' is no signal, expected one of: " + names);
}

double value_of(Signal signal, const std::string& text, const Line& line) {
  const SignalInfo& known = info(signal);
  if (text == session::kAbsent) return known.absent;
  if (const auto word = value_of_word(signal, text)) return *word;
  const auto value = number_in(text);
  if (value && (known.takes(*value) || *value == known.absent)) return *value;
  line.fail(known.name,
            "'" + text + "' is no value of it, expected " +
                (known.words.empty() ? known.range().text() : "one of " + std::string(known.words)));
}

/// "feed_pressure_bar" is the first boom's, "NAME.feed_pressure_bar" that of boom NAME. Nothing for a row of
/// what follows from the signals, or was told beside them.
std::optional<SignalId> id_of(const std::string& label, std::vector<std::string>& booms, const Line& line) {
  const std::size_t dot = label.rfind('.');
  const std::string boom = dot == std::string::npos ? "" : label.substr(0, dot);
  const std::string name = dot == std::string::npos ? label : label.substr(dot + 1);
  if (session::is_side_row(name)) return std::nullopt;
  const Signal signal = signal_of(name, line);
  auto known = std::find(booms.begin(), booms.end(), boom);
  if (known == booms.end()) {
    if (booms.size() == kMaxBooms)
      line.fail("signal", "'" + label + "' is of one boom too many, expected " + std::to_string(kMaxBooms) +
                              " at most");
    known = booms.insert(booms.end(), boom);
  }
  return SignalId{signal, static_cast<std::uint8_t>(known - booms.begin())};
}

std::optional<StateChange> change_of(const std::string& text, std::vector<std::string>& booms,
                                     const Line& line) {
  const std::size_t first = text.find(','), second = text.find(',', first + 1);
  if (first == std::string::npos || second == std::string::npos ||
      text.find(',', second + 1) != std::string::npos)
    line.fail("", "'" + text + "' is no row, expected " + kHeading);
  const auto time_s = number_in(text.substr(0, first));
  if (!time_s) line.fail("time_s", "'" + text.substr(0, first) + "' is no number, expected seconds");
  const auto id = id_of(text.substr(first + 1, second - first - 1), booms, line);
  if (!id) return std::nullopt;
  return StateChange{*time_s, *id, value_of(id->signal, text.substr(second + 1), line)};
}

}  // namespace

bool StateTable::holds(SignalId id) const {
  return std::any_of(changes.begin(), changes.end(), [&](const StateChange& change) {
    return change.signal.signal == id.signal && change.signal.boom == id.boom;
  });
}

StateTable read_states(const std::filesystem::path& file) {
  const InputFile input(file, "CSV " + kHeading);
  std::ifstream in(input.path());
  StateTable table{{""}, {}};
  Line line{input.name(), 0};
  for (std::string text; std::getline(in, text);) {
    ++line.number;
    if (!text.empty() && text.back() == '\r') text.pop_back();
    if (line.number == 1) {
      if (text != kHeading)
        line.fail("", "is no heading, expected " + kHeading + " as rigsound decode prints it");
      continue;
    }
    if (text.empty()) continue;
    const auto change = change_of(text, table.booms, line);
    if (!change) continue;
    if (!table.changes.empty() && change->time_s < table.changes.back().time_s)
      line.fail("time_s", "falls back, expected ascending times");
    table.changes.push_back(*change);
  }
  if (table.changes.empty()) throw InputError(input.name(), "holds no row, expected at least one");
  return table;
}

}  // namespace rigsound::session
