// A line that shows how far a long run has come.
#pragma once

#include <chrono>

namespace rigsound::tools {

/// Draws on stderr, over and over on the same line, with the time left; nothing when stderr is no terminal.
/// The line is cleared when the bar goes. Calls must not overlap. Thread: OFF.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(int done, int total);
  void clear();  ///< until the next show(): room for other lines

 private:
  bool terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rigsound::tools
