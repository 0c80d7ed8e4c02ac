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
  ModbusBus(const ModbusOptions& options, BusListener& listener, ModbusTap* tap);

  void report_exchange(
      const Exchange& exchange);  ///< to the tap, and what it says of the rig to the listener
  std::string text(const std::string& what) const { return name() + ": " + what; }

  ModbusOptions options_;
  struct Counts {
    std::atomic<std::uint64_t> requests{0};    // transactions that went well
    std::atomic<std::uint64_t> refused{0};     // answered, or met, with an exception
    std::atomic<std::uint64_t> bad_frames{0};  // bytes that are no Modbus
    std::atomic<std::uint64_t> rejected_connections{0};
    std::atomic<std::uint64_t> lost{0};  // client and RTU: times the other side went away
  };
  Counts count_;

 private:
  ModbusTap* tap_;
};

}  // namespace rigsound::modbus
