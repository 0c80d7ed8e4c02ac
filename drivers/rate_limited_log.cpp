#include "rate_limited_log.hpp"

namespace rigsound {
namespace {

constexpr std::int64_t kInterval_ms = 1000;

}  // namespace

void RateLimitedLog::add(const std::string& text, std::int64_t now_ms) {
  if (now_ms < next_ms_) {
    ++left_out_;
    return;
  }
  write_(left_out_ == 0 ? text : text + " (and " + std::to_string(left_out_) + " more warnings)");
  next_ms_ = now_ms + kInterval_ms;
  left_out_ = 0;
}

}  // namespace rigsound
