// HTTP on loopback: the one place that knows the library for it.
#pragma once

#include <functional>
#include <memory>

#include "access.hpp"
#include "http.hpp"

namespace rigsound::studio {

using Handler = std::function<Answer(const Request& request)>;

class HttpServer {
 public:
  /// Listens at 127.0.0.1; `port` 0: any that is free. `access` is asked before a body is read, `handle` from
  /// several threads at once. Errors: DeviceError. Thread: OFF.
  HttpServer(int port, Access& access, Handler handle);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const { return port_; }

  void serve();  ///< until stop()
  void stop();   ///< Thread: any

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  int port_ = 0;
};

}  // namespace rigsound::studio
