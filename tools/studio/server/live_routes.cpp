#include <memory>
#include <set>

#include "ctl/control_client.hpp"
#include "rigsound/device_error.hpp"
#include "routes.hpp"

namespace rigsound::studio {
namespace {

using tools::ControlClient;

const std::string& socket_of(const Workplace& place) {
  if (place.options.daemon.empty())
    throw ApiError(404, "there is no daemon: the studio was started without --daemon");
  return place.options.daemon;
}

/// What the daemon says to one that has subscribed.
class LiveEvents {
 public:
  explicit LiveEvents(const std::string& socket) : client_(std::make_unique<ControlClient>(socket)) {
    constexpr double kEvery_s = 0.1;
    client_->ask({{"command", "subscribe"}, {"every_s", kEvery_s}});
  }

  bool next(std::string& piece) {
    try {
      piece = config::json_line(client_->next_object()) + "\n";
      return true;
    } catch (const DeviceError& error) {
      piece = config::json_line({{"event", "gone"}, {"error", error.what()}}) + "\n";
      return false;
    }
  }

 private:
  std::unique_ptr<ControlClient> client_;
};

Answer events(const Workplace& place) {
  Answer answer;
  answer.type = "application/x-ndjson";
  answer.stream = [live = std::make_shared<LiveEvents>(socket_of(place))](std::string& piece) {
    return live->next(piece);
  };
  return answer;
}

Answer ask(const Workplace& place, const Request& request) {
  static const std::set<std::string> kCommands = {"status", "metrics",        "set",   "release",
                                                  "mute",   "exposure_reset", "reload"};
  const std::string& socket = socket_of(place);
  const Json body = request.object();
  if (kCommands.count(body.at("command").get<std::string>()) == 0)
    throw ApiError(400, "command: is none that the studio passes on");
  ControlClient client(socket);
  try {
    return json_answer(client.ask(body));
  } catch (const DeviceError&) {
    throw;
  } catch (const std::runtime_error& refused) {
    throw ApiError(400, refused.what());
  }
}

}  // namespace

void add_live_routes(Router& router, Workplace& place) {
  router.add("GET", "/live/events", [&place](const Request&) { return events(place); });
  router.add("POST", "/live", [&place](const Request& request) { return ask(place, request); });
}

}  // namespace rigsound::studio
