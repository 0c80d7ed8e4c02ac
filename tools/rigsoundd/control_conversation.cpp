#include "control_conversation.hpp"

#include <nettle/memops.h>

#include "rigsound/config/json.hpp"
#include "snapshot_json.hpp"

namespace rigsound::daemon {

// In a time that does not tell how much of it was right.
bool ControlConversation::is_token(const std::string& request) const {
  const Json said = config::parsed_json(request);
  if (!said.is_object() || said.size() != 1 || !said.contains("token") || !said["token"].is_string())
    return false;
  const std::string& token = said["token"].get_ref<const std::string&>();
  return token.size() == token_.size() && memeql_sec(token.data(), token_.data(), token.size()) != 0;
}

std::string ControlConversation::answer(const std::string& request) {
  if (!admitted_) {
    admitted_ = is_token(request);
    turned_away_ = !admitted_;
    return admitted_ ? "{\"ok\":true}\n"
                     : "{\"ok\":false,\"error\":\"expected {\\\"token\\\": TOKEN} first, with that of the "
                       "token_file\"}\n";
  }
  return daemon::answer(request, daemon_, client_);
}

std::string ControlConversation::news(double now_s) {
  if (!client_.subscription || !client_.subscription->due(now_s)) return {};
  return client_.subscription->line(status_json(daemon_.snapshot()), now_s);
}

void ControlConversation::news_not_taken(double now_s) {
  if (client_.subscription && client_.subscription->due(now_s)) client_.subscription->miss(now_s);
}

}  // namespace rigsound::daemon
