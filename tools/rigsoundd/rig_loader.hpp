// Reads rigs while the daemon goes on: a large sound set takes seconds.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "loaded_rig.hpp"
#include "rigsound/handoff/background_job.hpp"

namespace rigsound::daemon {

/// One rig at a time. Thread: CT.
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
  bool busy() const { return job_.busy(); }
  std::optional<Outcome> take() { return job_.take(); }  ///< once it is there
  /// Readable when there is something to take.
  pollfd to_poll() const { return job_.to_poll(); }

 private:
  BackgroundJob<Outcome> job_;
};

}  // namespace rigsound::daemon
