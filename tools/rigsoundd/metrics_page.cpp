#include "metrics_page.hpp"

#include <fmt/format.h>

namespace rigsound::daemon {

std::string MetricsPage::answer(const std::string&) {
  const std::string page = to_openmetrics(daemon_.scrape());
  told_ = true;
  return fmt::format(
      "HTTP/1.1 200 OK\r\nContent-Type: application/openmetrics-text; version=1.0.0; charset=utf-8\r\n"
      "Content-Length: {}\r\nConnection: close\r\n\r\n{}",
      page.size(), page);
}

}  // namespace rigsound::daemon
