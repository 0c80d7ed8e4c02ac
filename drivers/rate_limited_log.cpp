#include "rate_limited_log.hpp"

namespace rigsound {
namespace {

constexpr std::int64_t kInterval_ms = 60'000;

}  // namespace

void RateLimitedLog::add(const std::string& kind, const std::string& text, std::int64_t now_ms) {
  Kind& same = kinds_[kind];
  if (now_ms < same.next_ms) {
    ++same.left_out;
    return;
  }
  write_(same.left_out == 0 ? text : text + " (and " + std::to_string(same.left_out) + " more of this kind)");
  same = {now_ms + kInterval_ms, 0};
}

}  // namespace rigsound
