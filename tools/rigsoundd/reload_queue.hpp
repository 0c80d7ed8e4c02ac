// Who has asked for a reload, and what came of it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rigsound::daemon {

struct ReloadResult {
  std::string error;                     ///< empty: the new rig is in force
  std::vector<std::string> not_applied;  ///< keys that need a restart, with old and new value
};

/// One reload at a time; all who ask while one is under way share the next. Thread: CT.
class ReloadQueue {
 public:
  /// The number of the reload that reads the rig as it is now: one under way may have read it before.
  std::uint64_t ask() noexcept { return wanted_ = begun_ + 1; }

  bool due() const noexcept { return wanted_ > begun_ && begun_ == done_; }
  void begin() noexcept { ++begun_; }
  void finish(ReloadResult result) {
    last_ = std::move(result);
    done_ = begun_;
  }
  /// Null: it is not over.
  const ReloadResult* result(std::uint64_t number) const noexcept {
    return number <= done_ ? &last_ : nullptr;
  }

 private:
  std::uint64_t wanted_ = 0, begun_ = 0, done_ = 0;
  ReloadResult last_;
};

}  // namespace rigsound::daemon
