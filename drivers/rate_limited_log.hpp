// Warnings of a bus at most once a second, with the number of those left out.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace rigsound {

/// Thread: the bus's own.
class RateLimitedLog {
 public:
  explicit RateLimitedLog(std::function<void(const std::string&)> write) : write_(std::move(write)) {}
  void add(const std::string& text, std::int64_t now_ms);

 private:
  std::function<void(const std::string&)> write_;
  std::int64_t next_ms_ = 0;
  std::uint64_t left_out_ = 0;
};

}  // namespace rigsound
