#include "control_conversation.hpp"

#include "snapshot_json.hpp"

namespace rigsound::daemon {

std::string ControlConversation::answer(const std::string& request) {
  return daemon::answer(request, daemon_, subscription_);
}

std::string ControlConversation::news(double now_s) {
  if (!subscription_ || !subscription_->due(now_s)) return {};
  return subscription_->line(status_json(daemon_.snapshot()), now_s);
}

void ControlConversation::news_not_taken(double now_s) {
  if (subscription_ && subscription_->due(now_s)) subscription_->miss(now_s);
}

}  // namespace rigsound::daemon
