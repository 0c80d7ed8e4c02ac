// OpenMetrics over HTTP.
#pragma once

#include <string>

#include "commands.hpp"
#include "line_server.hpp"

namespace rigsound::daemon {

/// One answer: the page to `GET /metrics`, with any query; else 400 for what is no HTTP/1 request, 405 for
/// another method, 404 for another path. Thread: CT.
class MetricsPage : public Conversation {
 public:
  explicit MetricsPage(DaemonControl& daemon) : daemon_(daemon) {}

  std::string answer(const std::string& request) override;
  bool over() const override { return told_; }

 private:
  DaemonControl& daemon_;
  bool told_ = false;
};

}  // namespace rigsound::daemon
