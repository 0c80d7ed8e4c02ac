// A client of the control socket: requests and answers, and what it has subscribed to.
#pragma once

#include <optional>
#include <string>

#include "commands.hpp"
#include "line_server.hpp"
#include "subscription.hpp"

namespace rigsound::daemon {

/// Thread: CT.
class ControlConversation : public Conversation {
 public:
  explicit ControlConversation(DaemonControl& daemon) : daemon_(daemon) {}

  std::string answer(const std::string& request) override;
  std::string news(double now_s) override;
  void news_not_taken(double now_s) override;

 private:
  DaemonControl& daemon_;
  std::optional<Subscription> subscription_;
};

}  // namespace rigsound::daemon
