#include "modbus/complaints.hpp"

#include "modbus/context.hpp"

namespace rigsound::modbus {

void Complaints::add(const std::string& text) {
  const std::int64_t now = monotonic_ms();
  if (now - last_ms_ < 1000) {
    ++unsaid_;
    return;
  }
  listener_.notice(unsaid_ == 0 ? text : text + " (and " + std::to_string(unsaid_) + " more complaints)");
  last_ms_ = now;
  unsaid_ = 0;
}

}  // namespace rigsound::modbus
