// The one list of signals has every visitor it needs, and the README shows it.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "rigsound/machine/signal.hpp"
#include "rigsound/machine/state_guard.hpp"

using namespace rigsound;

namespace {

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string range(const SignalInfo& signal) {
  std::string text;
  if (!signal.words.empty()) {
    for (double value = signal.min; value <= signal.max; ++value)
      text += (text.empty() ? "" : ", ") + number(value) + " " +
              std::string(value_word(*signal_by_name(signal.name), value));
    return text;
  }
  text = number(signal.min) + "..." + number(signal.max);
  if (signal.kind == SignalKind::kNumberOrZero) text += " or 0";
  return signal.unit.empty() ? text : text + " " + std::string(signal.unit);
}

std::string readme_table() {
  std::string text = "| signal | range | per | what it is |\n| --- | --- | --- | --- |\n";
  for (const SignalInfo& signal : signal_table())
    text += "| `" + std::string(signal.name) + "` | " + range(signal) + " | " +
            (signal.per_boom ? "boom" : "rig") + " | " + std::string(signal.meaning) + " |\n";
  return text;
}

}  // namespace

TEST_CASE("the README's table of signals is the one list") {
  std::ifstream in(RIGSOUND_SOURCE "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(in), {}};
  CHECK_MESSAGE(readme.find(readme_table()) != std::string::npos, "expected in README.md:\n"
                                                                      << readme_table());
}

TEST_CASE("every signal has its own field of the state, and a range that holds its idle value") {
  for (const SignalInfo& signal : signal_table()) {
    CAPTURE(signal.name);
    CHECK(signal.min < signal.max);
    CHECK((signal.takes(signal.idle) || signal.idle == signal.absent));
    const MachineState before;
    CHECK(signal.get(before, 1) == signal.absent);
    MachineState after = before;
    const double other = signal.absent == signal.max ? signal.min : signal.max;
    signal.set(after, 1, other);
    CHECK(signal.get(after, 1) == static_cast<double>(static_cast<float>(other)));
    CHECK(before != after);
    CHECK(signal.get(after, 0) == (signal.per_boom ? signal.absent : signal.get(after, 1)));
    int changed = 0;
    for (const SignalInfo& each : signal_table())
      changed += each.get(before, 1) != each.get(after, 1) ? 1 : 0;
    CHECK(changed == 1);
  }
}

TEST_CASE("the guard knows every signal and every control: nothing out of range reaches the layers") {
  for (const SignalInfo& signal : signal_table()) {
    MachineState state;
    const bool whole = signal.kind == SignalKind::kWhole || signal.kind == SignalKind::kWord;
    if (signal.max == 65535) continue;  // fills its field: no value is out of range
    signal.set(state, 2, whole ? signal.max + 7 : signal.max * 4 + 1000);
    const double kept = signal.get(guarded(state), 2);
    CHECK_MESSAGE((signal.takes(kept) || kept == signal.absent), signal.name);
  }
  for (const ControlInfo& control : control_table()) {
    MachineState state;
    state.boom[3].controls.*control.field = static_cast<float>(control.max * 2);
    CHECK_MESSAGE(control.takes(static_cast<double>(guarded(state).boom[3].controls.*control.field)),
                  control.name);
  }
}
