// Whether a bus is up, and what was wrong last; each change goes to the log.
#pragma once

#include <mutex>
#include <string>

namespace rigsound::daemon {

/// Thread: any.
class BusStatus {
 public:
  explicit BusStatus(std::string name) : name_(std::move(name)) {}

  void up();
  void down(const std::string& why);
  void notice(const std::string& text);

  const std::string& name() const { return name_; }
  bool is_up() const;
  std::string last_problem() const;  ///< empty while all is well

 private:
  std::string without_name(const std::string& text) const;

  std::string name_;
  mutable std::mutex mutex_;
  bool up_ = false;
  std::string problem_;
};

}  // namespace rigsound::daemon
