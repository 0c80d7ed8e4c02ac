// Warnings of a bus at most once a minute for each kind, with the number of those left out.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace rigsound {

/// Thread: the bus's own.
class RateLimitedLog {
 public:
  explicit RateLimitedLog(std::function<void(const std::string&)> write) : write_(std::move(write)) {}
  /// `kind`: what the warning is about, the same for all of its kind.
  void add(const std::string& kind, const std::string& text, std::int64_t now_ms);

 private:
  struct Kind {
    std::int64_t next_ms = 0;
    std::uint64_t left_out = 0;
  };
  std::function<void(const std::string&)> write_;
  std::map<std::string, Kind> kinds_;
};

}  // namespace rigsound
