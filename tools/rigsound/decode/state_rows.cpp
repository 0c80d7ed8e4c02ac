#include "decode/state_rows.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <system_error>

#include "decode/row_text.hpp"
#include "rigsound/session/state_rows.hpp"

namespace rigsound::tools {
namespace {

constexpr std::size_t kWrittenAtOnce = 1 << 16;

/// The shortest that reads as this state's value; a value that no bus can say is one that is absent.
std::string value_text(Signal signal, double value) {
  if (!info(signal).takes(value)) return std::string(session::kAbsent);
  const std::string_view word = value_word(signal, value);
  return word.empty() ? fmt::format("{}", static_cast<float>(value)) : std::string(word);
}

}  // namespace

StateRows::StateRows(const config::Rig& rig, Form form, std::FILE* out)
    : rig_(rig),
      form_(form),
      out_(out),
      situations_(rig.engine.booms.size(), session::SituationTrace(rig.engine.scene)) {
  append(form == Form::kCsv ? figures(0, "", "").csv_head() : "{\"changes\": [\n");
}

std::string StateRows::label(int boom, std::string_view name) const {
  return boom == 0 ? std::string(name) : fmt::format("{}.{}", rig_.engine.booms[boom].name, name);
}

FigureRow StateRows::figures(double time_s, std::string_view label, std::string_view value) {
  FigureRow figures;
  figures.add("time_s", time_s, "{:.6f}").add("signal", std::string(label));
  double number = 0;
  const char *begin = value.data(), *end = begin + value.size();
  const bool is_number = std::from_chars(begin, end, number).ptr == end;
  return is_number ? figures.add_text("value", std::string(value), number)
                   : figures.add("value", std::string(value));
}

void StateRows::add(double time_s, std::string_view label, std::string_view value) {
  if (form_ == Form::kCsv)
    append_seconds(text_, time_s), append(","), append(label), append(","), append(value), append("\n");
  else
    append(between_), append(config::json_line(figures(time_s, label, value).json()));
  between_ = ",\n";
  if (text_.size() >= kWrittenAtOnce) write_out();
}

void StateRows::write_out() {
  if (std::fwrite(text_.data(), 1, text_.size(), out_) != text_.size())
    throw std::system_error(errno, std::generic_category());
  text_.clear();
}

void StateRows::finish() {
  if (form_ == Form::kJson) append("\n]}\n");
  write_out();
}

void StateRows::add_situation(double time_s, int boom, const BoomState& state) {
  const session::SituationTrace::Change change = situations_[boom].update(state);
  if (change.situation)
    add(time_s, label(boom, session::kSituationRow), std::string(name(*change.situation)));
  if (change.feed_deviation)
    add(time_s, label(boom, session::kFeedDeviationRow), fmt::format("{:.2f}", *change.feed_deviation));
}

void StateRows::add_state(double time_s, const MachineState& state) {
  add_signals(time_s, state);
  add_controls(time_s, state);
  add_output_gain(time_s, state);
  add_by_hand(time_s, state);
  for (int b = 0; b < booms(); ++b) add_situation(time_s, b, state.boom[b]);
  last_ = state;
}

void StateRows::add_signals(double time_s, const MachineState& state) {
  for_each_signal(booms(), [&](SignalId id) {
    const double value = info(id.signal).get(state, id.boom);
    if (value != info(id.signal).get(last_, id.boom))
      add(time_s, config::signal_label(rig_, id), value_text(id.signal, value));
  });
}

void StateRows::add_controls(double time_s, const MachineState& state) {
  for (int b = 0; b < booms(); ++b)
    for (const ControlInfo& control : control_table()) {
      const float value = state.boom[b].controls.*control.field;
      if (value != last_.boom[b].controls.*control.field)
        add(time_s, label(b, control.name), fmt::format("{}", value));
    }
}

// A fade would say every block, so hundredths.
void StateRows::add_output_gain(double time_s, const MachineState& state) {
  const std::string gain =
      fmt::format("{:.2g}", std::round(static_cast<double>(state.output_gain) * 100) / 100);
  if (gain != last_gain_) add(time_s, std::string(session::kOutputGainRow), gain);
  last_gain_ = gain;
}

void StateRows::add_by_hand(double time_s, const MachineState& state) {
  std::string held;
  for_each_signal(booms(), [&](SignalId id) {
    if (is_by_hand(state, id)) held += (held.empty() ? "" : " ") + config::signal_label(rig_, id);
  });
  if (held.empty()) held = "none";
  if (held != last_by_hand_) add(time_s, std::string(session::kManualRow), held);
  last_by_hand_ = held;
}

}  // namespace rigsound::tools
