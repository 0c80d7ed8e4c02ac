// Another program of ours, run beside the server: what it says, line by line, and how it ended.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace rigsound::studio {

/// Thread: run() one, stop() any. The process ends with this server, killed or not.
class ChildProcess {
 public:
  /// `words`: the program and its arguments.
  explicit ChildProcess(std::vector<std::string> words) : words_(std::move(words)) {}

  struct Ending {
    int code = 0;                     ///< exit code; 128 + N when signal N ended it
    std::vector<std::string> errors;  ///< lines of standard error, the last ones
  };

  /// Calls `line` for each line of standard output, in this thread, until the process has ended. Errors:
  /// DeviceError when it cannot be started.
  Ending run(const std::function<void(const std::string&)>& line);

  void stop();  ///< asks it to end (SIGTERM); it leaves nothing half made

 private:
  std::vector<std::string> words_;
  std::atomic<int> pid_{0};
  std::atomic<bool> stopped_{false};
};

}  // namespace rigsound::studio
