// Audacity label tracks: which stretch of a recording is which drilling situation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/machine/situation.hpp"

namespace rigsound::analysis {

constexpr double kLabelSlack_s = 0.05;  ///< labels are set by hand

struct Label {
  double start_s = 0, end_s = 0;
  Situation situation = Situation::kNormal;
  int rods = 0;                             ///< 1...20; 0: not said
  std::string rock;                         ///< empty: not said
  double rpm = 0;                           ///< r/min of the diesel; 0: not said
  double feed_bar = 0, percussion_bar = 0;  ///< 1...300 bar; 0: not said
  int line = 0;                             ///< in the label file
};

/// Lines of `start<TAB>end<TAB>situation[ key=value]...`, seconds, keys `rods`, `rock`, `rpm`, `feed`,
/// `percussion` (bar); in file order. Blank lines and Audacity's frequency lines (starting with a backslash)
/// are passed over. Errors: InputError with file, line and key. Thread: OFF.
std::vector<Label> read_labels(const std::filesystem::path& path);

/// The same of a text; `name` stands for the file in messages.
std::vector<Label> read_labels_text(const std::string& text, const std::string& name);

/// "normal rods=2 rock=hard rpm=1500 feed=110": what a label says, as a track has it. Thread: any.
std::string label_words(const Label& label);

/// A whole track, a line a label, which read_labels() reads back; times in microseconds. Thread: any.
std::string labels_text(const std::vector<Label>& labels);

}  // namespace rigsound::analysis
