#include "http_server.hpp"

#include <httplib.h>

#include <chrono>
#include <thread>

#include "rigsound/device_error.hpp"

namespace rigsound::studio {
namespace {

// A browser opens six connections a page, of which each stream holds one.
constexpr std::size_t kConnections = 32;
constexpr int kKeepAliveRequests = 1000;

// Nothing is loaded from elsewhere, nothing inline is run; a page of others cannot show or read this one.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:; "
    "media-src 'self' blob:; connect-src 'self'; worker-src 'self'; font-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

Origin origin_of(const httplib::Request& r) {
  Origin from;
  from.method = r.method;
  from.path = r.path;
  from.host = r.get_header_value("Host");
  from.origin = r.get_header_value("Origin");
  from.fetch_site = r.get_header_value("Sec-Fetch-Site");
  from.token = r.get_header_value("X-Rigsound-Token");
  from.content_type = r.get_header_value("Content-Type");
  from.content_encoding = r.get_header_value("Content-Encoding");
  from.transfer_encoding = r.get_header_value("Transfer-Encoding");
  from.content_length = r.get_header_value<std::uint64_t>("Content-Length");
  return from;
}

Request request_of(const httplib::Request& r) {
  Request request;
  request.method = r.method == "HEAD" ? "GET" : r.method;
  request.path = r.path;
  request.body = r.body;
  for (const auto& [name, value] : r.params) request.query.emplace(name, value);
  return request;
}

void stream(Answer answer, httplib::Response& to) {
  static constexpr auto kPause = std::chrono::milliseconds(50);
  to.set_chunked_content_provider(answer.type,
                                  [next = std::move(answer.stream)](std::size_t, httplib::DataSink& sink) {
                                    std::string piece;
                                    bool more = false;
                                    try {
                                      more = next(piece);
                                    } catch (const std::exception&) {
                                      return false;
                                    }
                                    if (!piece.empty() && !sink.write(piece.data(), piece.size()))
                                      return false;
                                    if (!more) sink.done();
                                    if (more && piece.empty()) std::this_thread::sleep_for(kPause);
                                    return true;
                                  });
}

void put(Answer answer, httplib::Response& to) {
  to.status = answer.status;
  for (const auto& [name, value] : answer.headers) to.set_header(name, value);
  if (answer.headers.count("Cache-Control") == 0) to.set_header("Cache-Control", "no-store");
  if (answer.stream)
    stream(std::move(answer), to);
  else
    to.set_content(answer.body, answer.type);
}

}  // namespace

struct HttpServer::Parts {
  httplib::Server server;
};

HttpServer::HttpServer(int port, Access& access, Handler handle) : parts_(std::make_unique<Parts>()) {
  httplib::Server& server = parts_->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(kConnections); };
  server.set_keep_alive_max_count(kKeepAliveRequests);
  server.set_payload_max_length(kMostResultBytes);
  server.set_tcp_nodelay(true);
  server.set_socket_options([](socket_t socket) {  // without SO_REUSEPORT: nobody else may listen there too
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_default_headers({{"Content-Security-Policy", kPolicy},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cross-Origin-Opener-Policy", "same-origin"},
                              {"Cross-Origin-Resource-Policy", "same-origin"}});
  server.set_pre_routing_handler([&access](const httplib::Request& request, httplib::Response& response) {
    const std::optional<Refusal> refusal = access.refusal(origin_of(request));
    if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
    put(error_answer({refusal->status, refusal->line}), response);
    response.set_header("Connection", "close");  // its body is not read
    return httplib::Server::HandlerResponse::Handled;
  });
  const auto answer = [handle = std::move(handle)](const httplib::Request& request,
                                                   httplib::Response& response) {
    put(handle(request_of(request)), response);
  };
  constexpr const char* kAnything = R"([\s\S]*)";
  server.Get(kAnything, answer).Put(kAnything, answer).Post(kAnything, answer).Delete(kAnything, answer);
  server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (response.body.empty() && !response.content_provider_)
      put(error_answer({response.status, "the request makes no sense"}), response);
  });
  constexpr const char* kLoopback = "127.0.0.1";
  port_ = port == 0 ? server.bind_to_any_port(kLoopback) : server.bind_to_port(kLoopback, port) ? port : -1;
  if (port_ < 0)
    throw DeviceError(std::string(kLoopback) + ":" + std::to_string(port) +
                      ": cannot be listened at, is it taken?");
  access.set_port(port_);
}

HttpServer::~HttpServer() = default;

void HttpServer::serve() { parts_->server.listen_after_bind(); }

void HttpServer::stop() { parts_->server.stop(); }

}  // namespace rigsound::studio
