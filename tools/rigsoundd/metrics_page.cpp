#include "metrics_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace rigsound::daemon {
namespace {

struct RequestLine {
  std::string_view method, path;
};

bool is_http_1(std::string_view version) {
  constexpr std::string_view kVersion = "HTTP/1.";
  return version.size() == kVersion.size() + 1 && version.substr(0, kVersion.size()) == kVersion &&
         version.back() >= '0' && version.back() <= '9';
}

/// Of RFC 9112, section 3: three words with a blank between. Nothing: malformed.
std::optional<RequestLine> request_line(std::string_view request) {
  const std::string_view line = request.substr(0, request.find("\r\n"));
  const std::size_t first = line.find(' '), last = line.rfind(' ');
  if (first == std::string_view::npos || last <= first + 1) return std::nullopt;
  const std::string_view method = line.substr(0, first), target = line.substr(first + 1, last - first - 1);
  const bool token =
      !method.empty() && std::all_of(method.begin(), method.end(), [](char c) { return c > ' ' && c < 127; });
  if (!token || !is_http_1(line.substr(last + 1)) || target.find(' ') != std::string_view::npos)
    return std::nullopt;
  return RequestLine{method, target.substr(0, target.find('?'))};
}

std::string response(std::string_view status, std::string_view type, std::string_view text) {
  return fmt::format("HTTP/1.1 {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nConnection: close\r\n\r\n{}",
                     status, type, text.size(), text);
}

std::string refusal(std::string_view status) {
  return response(status, "text/plain; charset=utf-8", "expected GET /metrics\n");
}

}  // namespace

std::string MetricsPage::answer(const std::string& request) {
  told_ = true;
  const auto line = request_line(request);
  if (!line) return refusal("400 Bad Request");
  if (line->method != "GET") return refusal("405 Method Not Allowed\r\nAllow: GET");
  if (line->path != "/metrics") return refusal("404 Not Found");
  return response("200 OK", "application/openmetrics-text; version=1.0.0; charset=utf-8",
                  to_openmetrics(daemon_.scrape()));
}

}  // namespace rigsound::daemon
