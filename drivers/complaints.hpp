// Says what goes wrong on a bus at most once a second, and how much was left unsaid.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace rigsound {

/// Thread: the bus's own.
class Complaints {
 public:
  explicit Complaints(std::function<void(const std::string&)> tell) : tell_(std::move(tell)) {}
  void add(const std::string& text);

 private:
  std::function<void(const std::string&)> tell_;
  std::chrono::steady_clock::time_point next_;
  std::uint64_t unsaid_ = 0;
};

}  // namespace rigsound
