// A line that shows how far a long run has come.
#pragma once

#include <chrono>
#include <string>

namespace rigsound::tools {

/// Draws on stderr, over and over on the same line, with the time left; nothing when stderr is no terminal.
/// The line is cleared when the bar goes. Calls must not overlap. Thread: OFF.
class ProgressBar {
 public:
  /// What the verb prints meanwhile. Rows on the bar's own terminal would lie across it: nothing is drawn
  /// then.
  enum class Beside { kNothing, kRows };

  explicit ProgressBar(Beside beside = Beside::kNothing);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(int done, int total);
  void show(double share);  ///< of the work, 0...1; as often as one likes
  void clear();             ///< until the next show(): room for other lines

  bool seen() const { return terminal_; }  ///< whether anybody looks

 private:
  void draw(double share, const std::string& count);

  bool terminal_;
  int last_tenth_ = -1;  ///< of a second, when a share was drawn
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rigsound::tools
