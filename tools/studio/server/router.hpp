// Which function answers which path.
#pragma once

#include <string>
#include <vector>

#include "http_server.hpp"

namespace rigsound::studio {

class Router {
 public:
  /// `pattern`: below /api/v1, such as "/banks/{}/sound/{}"; what stands for {} is Request::words. Thread:
  /// OFF.
  void add(const std::string& method, const std::string& pattern, Handler handler);

  /// Errors of every kind become answers. Thread: any.
  Answer answer(Request request) const;

 private:
  struct Route {
    std::string method;
    std::vector<std::string> parts;
    Handler handler;
  };
  std::vector<Route> routes_;
};

}  // namespace rigsound::studio
