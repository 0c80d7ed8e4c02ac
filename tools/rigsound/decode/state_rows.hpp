// Rows `time_s,signal,value` of what the engine is told, and of what follows from it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figure_row.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/session/situation_trace.hpp"

namespace rigsound::tools {

/// Thread: OFF.
class StateRows {
 public:
  enum class Form { kCsv, kJson };

  explicit StateRows(const config::Rig& rig);  ///< must outlive it

  void add(double time_s, const std::string& label, const std::string& value);
  /// `situation` and `feed_deviation` of a boom, when they have changed.
  void add_situation(double time_s, int boom, const BoomState& state);
  /// Everything in which a session's `state` differs from the one before; of the first, from one in which
  /// nothing was told.
  void add_state(double time_s, const MachineState& state);

  /// "NAME" of the first boom, "BOOM.NAME" of another.
  std::string label(int boom, std::string_view name) const;
  /// All rows, as CSV or as one JSON document.
  std::string text(Form form) const;

 private:
  void add_signals(double time_s, const MachineState& state);
  void add_controls(double time_s, const MachineState& state);
  void add_output_gain(double time_s, const MachineState& state);
  void add_by_hand(double time_s, const MachineState& state);
  int booms() const { return static_cast<int>(rig_.engine.booms.size()); }

  const config::Rig& rig_;
  struct Row {
    double time_s;
    std::string signal, value;
  };

  static FigureRow figures(const Row& row);

  std::vector<Row> rows_;
  std::vector<session::SituationTrace> situations_;
  MachineState last_;
  std::string last_gain_ = "1";
  std::string last_by_hand_ = "none";
};

}  // namespace rigsound::tools
