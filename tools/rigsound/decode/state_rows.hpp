// Rows `time_s,signal,value` of what the engine is told, and of what follows from it.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "figure_row.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/session/situation_trace.hpp"

namespace rigsound::tools {

/// Written as they come, 64 KiB at a time: what is found wrong with a short input is found before anything is
/// written. Thread: OFF.
class StateRows {
 public:
  enum class Form { kCsv, kJson };

  StateRows(const config::Rig& rig, Form form, std::FILE* out);  ///< `rig` must outlive it

  void add(double time_s, std::string_view label, std::string_view value);
  /// `situation` and `feed_deviation` of a boom, when they have changed.
  void add_situation(double time_s, int boom, const BoomState& state);
  /// Everything in which a session's `state` differs from the one before; of the first, from one in which
  /// nothing was told.
  void add_state(double time_s, const MachineState& state);

  /// "NAME" of the first boom, "BOOM.NAME" of another.
  std::string label(int boom, std::string_view name) const;
  /// The end of the document.
  void finish();

 private:
  void append(std::string_view text) { text_.append(text.data(), text.data() + text.size()); }
  void add_signals(double time_s, const MachineState& state);
  void add_controls(double time_s, const MachineState& state);
  void add_output_gain(double time_s, const MachineState& state);
  void add_by_hand(double time_s, const MachineState& state);
  int booms() const { return static_cast<int>(rig_.engine.booms.size()); }

  static FigureRow figures(double time_s, std::string_view label, std::string_view value);
  void write_out();

  const config::Rig& rig_;
  Form form_;
  std::FILE* out_;
  fmt::memory_buffer text_;   // not yet written
  const char* between_ = "";  // rows of JSON
  std::vector<session::SituationTrace> situations_;
  MachineState last_;
  std::string last_gain_ = "1";
  std::string last_by_hand_ = "none";
};

}  // namespace rigsound::tools
