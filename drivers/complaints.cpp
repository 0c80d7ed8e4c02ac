#include "complaints.hpp"

namespace rigsound {

void Complaints::add(const std::string& text) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) {
    ++unsaid_;
    return;
  }
  tell_(unsaid_ == 0 ? text : text + " (and " + std::to_string(unsaid_) + " more complaints)");
  next_ = now + std::chrono::seconds(1);
  unsaid_ = 0;
}

}  // namespace rigsound
