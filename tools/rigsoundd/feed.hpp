// One bus of the rig on its own thread, feeding the state.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/modbus/modbus_options.hpp"
#include "state_exchange.hpp"

namespace rigsound::daemon {

struct FeedStatus {
  std::string name;  ///< "can can0", "modbus 127.0.0.1:1502"
  bool up = false;
  std::string problem;  ///< empty while all is well
  std::vector<std::pair<std::string, std::uint64_t>> counters;
};

/// Runs from construction to destruction, which takes up to 0.2 s, or a device's time-out.
class Feed {
 public:
  virtual ~Feed() = default;
  virtual FeedStatus status() const = 0;  ///< Thread: CT
};

std::unique_ptr<Feed> make_feed(const can::CanOptions& options, StateExchange& exchange);
std::unique_ptr<Feed> make_feed(const modbus::ModbusOptions& options, StateExchange& exchange);

}  // namespace rigsound::daemon
