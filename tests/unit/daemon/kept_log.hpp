// What the daemon writes to its log, kept while a test looks.
#pragma once

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace rigsound::test {

/// Begins before the first thread that logs, and ends after the last.
class KeptLog {
 public:
  KeptLog() { spdlog::set_default_logger(std::make_shared<spdlog::logger>("kept", sink_)); }
  ~KeptLog() { spdlog::set_default_logger(before_); }
  KeptLog(const KeptLog&) = delete;
  KeptLog& operator=(const KeptLog&) = delete;

  /// As "warning: text", in order.
  std::vector<std::string> lines() const { return sink_->lines(); }
  /// How many begin so.
  std::ptrdiff_t count(std::string_view begin) const {
    const std::vector<std::string> all = lines();
    return std::count_if(all.begin(), all.end(),
                         [&](const std::string& line) { return line.compare(0, begin.size(), begin) == 0; });
  }

 private:
  class Sink : public spdlog::sinks::base_sink<std::mutex> {
   public:
    std::vector<std::string> lines() {
      const std::lock_guard<std::mutex> lock(mutex_);
      return lines_;
    }

   private:
    void sink_it_(const spdlog::details::log_msg& message) override {
      const auto level = spdlog::level::to_string_view(message.level);
      lines_.push_back(std::string(level.data(), level.size()) + ": " +
                       std::string(message.payload.data(), message.payload.size()));
    }
    void flush_() override {}

    std::vector<std::string> lines_;
  };

  std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
  std::shared_ptr<Sink> sink_ = std::make_shared<Sink>();
};

}  // namespace rigsound::test
