// What clients and servers do alike: exchanges into readings, counters.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "bus/bus_base.hpp"
#include "rigsound/modbus/modbus_bus.hpp"

namespace rigsound::modbus {

class ModbusBus : public BusBase {
 public:
  std::vector<BusCounter> counters() const override;

 protected:
  /// `address`: of the line, for the bus's name; `routes`: all that it delivers.
  ModbusBus(const std::string& address, const std::vector<RegisterRoute>& routes, BusListener& listener,
            ModbusTap* tap);

  /// To the tap, and what it says of these routes to the listener.
  void report_exchange(const Exchange& exchange, const std::vector<RegisterRoute>& routes);

  struct Counts {
    std::atomic<std::uint64_t> requests{0};    // transactions that went well
    std::atomic<std::uint64_t> refused{0};     // answered, or met, with an exception
    std::atomic<std::uint64_t> bad_frames{0};  // bytes that are no Modbus
    std::atomic<std::uint64_t> rejected_connections{0};
    std::atomic<std::uint64_t> evicted_connections{0};  // to make room for the next
    std::atomic<std::uint64_t> lost{0};                 // client and RTU: times the other side went away
  };
  Counts count_;

 private:
  ModbusTap* tap_;
};

}  // namespace rigsound::modbus
