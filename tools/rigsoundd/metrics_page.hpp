// OpenMetrics over HTTP.
#pragma once

#include <string>

#include "commands.hpp"
#include "line_server.hpp"

namespace rigsound::daemon {

/// One answer, the same whatever is asked for. Thread: CT.
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
