#include "router.hpp"

#include <system_error>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::studio {
namespace {

constexpr const char *kRoot = "/api/v1", *kAny = "{}";

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t from = 1; from <= path.size();) {
    const std::size_t to = std::min(path.find('/', from), path.size());
    parts.push_back(path.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

bool fits(const std::vector<std::string>& pattern, const std::vector<std::string>& path,
          std::vector<std::string>& words) {
  if (pattern.size() != path.size()) return false;
  words.clear();
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (pattern[i] == kAny)
      words.push_back(path[i]);
    else if (pattern[i] != path[i])
      return false;
  }
  return true;
}

Answer failure(int status, const std::exception& error) { return error_answer({status, error.what()}); }

}  // namespace

void Router::add(const std::string& method, const std::string& pattern, Handler handler) {
  routes_.push_back({method, parts_of(kRoot + pattern), std::move(handler)});
}

Answer Router::answer(Request request) const {
  const std::vector<std::string> path = parts_of(request.path);
  bool known = false;
  try {
    for (const Route& route : routes_) {
      if (!fits(route.parts, path, request.words)) continue;
      known = true;
      if (route.method == request.method) return route.handler(request);
    }
  } catch (const ApiError& error) {
    return error_answer(error);
  } catch (const InputError& error) {
    return failure(422, error);
  } catch (const DeviceError& error) {
    return failure(503, error);
  } catch (const std::system_error& error) {
    return failure(503, error);
  } catch (const std::invalid_argument& error) {
    return failure(400, error);
  } catch (const Json::exception&) {
    return error_answer({400, "body: a value is missing or of the wrong kind"});
  } catch (const std::exception& error) {
    return failure(500, error);
  }
  return error_answer(known ? ApiError(405, "the path does not take that method")
                            : ApiError(404, "there is no such path"));
}

}  // namespace rigsound::studio
