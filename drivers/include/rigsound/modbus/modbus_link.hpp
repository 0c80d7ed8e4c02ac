// A Modbus link of a rig: as client it asks a PLC, as server a simulator writes to it; TCP or RTU.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/modbus/exchange.hpp"
#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

/// Told what happens on the link, from the thread that runs it.
class ModbusListener {
 public:
  virtual ~ModbusListener() = default;
  virtual void readings(const std::vector<Reading>& readings) = 0;
  virtual void exchange(const Exchange&) {}          ///< every agreed transaction, for recording
  virtual void up() = 0;                             ///< the link works from now on
  virtual void down(const std::string& why) = 0;     ///< it no longer does; every signal of it is in doubt
  virtual void notice(const std::string& text) = 0;  ///< worth a line in the log, at most one a second
};

struct ModbusCounters {
  std::uint64_t requests = 0;     ///< transactions that went well
  std::uint64_t refused = 0;      ///< answered, or met, with an exception
  std::uint64_t bad_frames = 0;   ///< bytes that are no Modbus
  std::uint64_t turned_away = 0;  ///< server: connections over the limit or from a network not allowed
  std::uint64_t lost = 0;         ///< client and RTU: times the other side went away
  std::uint64_t connections = 0;  ///< server: open now
};

class ModbusLink {
 public:
  virtual ~ModbusLink() = default;
  virtual void step() = 0;  ///< one round: waits at most 0.2 s unless the device itself takes longer
  void run(const std::atomic<bool>& stop);   ///< rounds until `stop`. Thread: the link's own
  ModbusCounters counters() const noexcept;  ///< Thread: any

 protected:
  struct Atomics {
    std::atomic<std::uint64_t> requests{0}, refused{0}, bad_frames{0}, turned_away{0}, lost{0},
        connections{0};
  };
  Atomics count_;
};

/// A device that is missing is no error: it is looked for with pauses of 0.1 s doubling to 5 s.
std::unique_ptr<ModbusLink> make_modbus_link(const ModbusOptions& options, ModbusListener& listener);

}  // namespace rigsound::modbus
