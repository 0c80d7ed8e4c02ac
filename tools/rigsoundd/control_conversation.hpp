// A client of the control socket: requests and answers, and what it has subscribed to.
#pragma once

#include <string>
#include <utility>

#include "commands.hpp"
#include "line_server.hpp"

namespace rigsound::daemon {

/// Thread: CT.
class ControlConversation : public Conversation {
 public:
  /// `token`: the first request must be {"token": TOKEN}, and ends the conversation when it is not; empty:
  /// none.
  explicit ControlConversation(DaemonControl& daemon, std::string token = {})
      : daemon_(daemon), token_(std::move(token)), admitted_(token_.empty()) {}

  std::string answer(const std::string& request) override;
  std::string late_answer() override { return daemon::late_answer(daemon_, client_); }
  std::string news(double now_s) override;
  void news_not_taken(double now_s) override;
  bool wants_news() const override { return client_.subscription.has_value(); }
  bool over() const override { return turned_away_; }

 private:
  bool is_token(const std::string& request) const;

  DaemonControl& daemon_;
  std::string token_;
  bool admitted_, turned_away_ = false;
  ClientState client_;
};

}  // namespace rigsound::daemon
