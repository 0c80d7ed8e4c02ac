// Whether a bus is up, and what was wrong last; changes go to the log, at most one line a minute.
#pragma once

#include <cstdint>
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
  void poll(std::int64_t now_ms);  ///< writes a change that had to wait; to be called now and then

  const std::string& name() const { return name_; }
  bool is_up() const;
  std::string last_problem() const;  ///< empty while all is well

 private:
  std::string without_name(const std::string& text) const;

  std::string name_;
  mutable std::mutex mutex_;
  void log_change(std::int64_t now_ms);

  bool up_ = false;
  std::int64_t next_line_ms_ = 0;
  int changes_ = 0;  // since the last line
  std::string problem_;
};

}  // namespace rigsound::daemon
