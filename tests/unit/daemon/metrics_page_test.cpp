// What the metrics port answers to whatever is asked.
#include "metrics_page.hpp"

#include <doctest/doctest.h>

#include <string>

#include "daemon/scraped.hpp"

using namespace rigsound;
using namespace rigsound::daemon;
using test::Scraped;

namespace {

std::string first_line(Scraped& daemon, const std::string& request) {
  MetricsPage page(daemon);
  CHECK_FALSE(page.over());
  const std::string answer = page.answer(request);
  CHECK(page.over());
  const std::size_t head = answer.find("\r\n\r\n");
  REQUIRE(head != std::string::npos);
  CHECK(answer.find("\r\nContent-Length: " + std::to_string(answer.size() - head - 4) + "\r\n") !=
        std::string::npos);
  return answer.substr(0, answer.find("\r\n"));
}

}  // namespace

TEST_CASE("GET /metrics gets the page, with a query or headers too") {
  Scraped daemon;
  for (const char* request : {"GET /metrics HTTP/1.1\r\nHost: a\r\nAccept: */*", "GET /metrics HTTP/1.0",
                              "GET /metrics?name[]=x HTTP/1.1\r\nHost: a"})
    CHECK(first_line(daemon, request) == "HTTP/1.1 200 OK");
  CHECK(daemon.scrapes == 3);
  const std::string answer = MetricsPage(daemon).answer("GET /metrics HTTP/1.1");
  CHECK(answer.find("Content-Type: application/openmetrics-text; version=1.0.0; charset=utf-8\r\n") !=
        std::string::npos);
  CHECK(answer.substr(answer.size() - 6) == "# EOF\n");
}

TEST_CASE("Another method, another path and what is no request are refused, and scrape nothing") {
  Scraped daemon;
  for (const char* method : {"POST", "HEAD", "PUT", "get", "M-SEARCH", "DELETE"})
    CHECK(first_line(daemon, std::string(method) + " /metrics HTTP/1.1") ==
          "HTTP/1.1 405 Method Not Allowed");
  CHECK(MetricsPage(daemon).answer("POST /metrics HTTP/1.1").find("\r\nAllow: GET\r\n") != std::string::npos);
  for (const char* path : {"/", "/metrics/", "/metric", "/../metrics", "*", "http://a/metrics"})
    CHECK(first_line(daemon, std::string("GET ") + path + " HTTP/1.1") == "HTTP/1.1 404 Not Found");
  for (const char* request :
       {"", " ", "GET", "GET /metrics", "GET /metrics HTTP/2.0", "GET /metrics HTTP/1.x", "GET  HTTP/1.1",
        "GET  /metrics HTTP/1.1", " GET /metrics HTTP/1.1", "GET /metrics HTTP/1.1 ", "GET /a /b HTTP/1.1",
        "G\x01T /metrics HTTP/1.1", "\r\nGET /metrics HTTP/1.1", "GET /metrics HTTP/1.11", "\x16\x03\x01"})
    CHECK(first_line(daemon, request) == "HTTP/1.1 400 Bad Request");
  for (const char* request : {"G\x7fT /metrics HTTP/1.1", " /metrics HTTP/1.1", "GET /metrics HTTP/1./",
                              "GET /metrics HTTP/1.:", "GET /metrics HTTP/1."})
    CHECK(first_line(daemon, request) == "HTTP/1.1 400 Bad Request");
  CHECK(daemon.scrapes == 0);
}
