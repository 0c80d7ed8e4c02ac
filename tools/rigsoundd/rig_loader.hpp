// Reads rigs while the daemon goes on: a large sound set takes seconds.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "loaded_rig.hpp"
#include "rigsound/bus/stop_event.hpp"

namespace rigsound::daemon {

/// One rig at a time, on a thread of its own that nobody waits for: destruction abandons it. Thread: CT.
class RigLoader {
 public:
  struct Outcome {
    LoadedRig rig;
    std::vector<std::string> not_applied;
    std::string error;  ///< empty: `rig` is whole
  };
  /// Fills `not_applied`. Must not use what the daemon may change or destroy meanwhile.
  using Load = std::function<LoadedRig(std::vector<std::string>& not_applied)>;

  /// Errors: none; whatever `load` throws is the outcome. Not while busy.
  void begin(Load load);
  bool busy() const { return job_ != nullptr; }
  std::optional<Outcome> take();  ///< once it is there
  /// Readable when there is something to take.
  pollfd to_poll() const { return job_ ? job_->done.to_poll() : pollfd{-1, 0, 0}; }

 private:
  struct Job {
    Load load;
    Outcome outcome;
    StopEvent done;
  };
  std::shared_ptr<Job> job_;
};

}  // namespace rigsound::daemon
