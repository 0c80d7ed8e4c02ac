// A libmodbus context that frees itself, and the pause between attempts to reach a device.
#pragma once

#include <modbus.h>

#include <memory>

#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

struct FreeContext {
  void operator()(modbus_t* context) const {
    modbus_close(context);
    modbus_free(context);
  }
};
using Context = std::unique_ptr<modbus_t, FreeContext>;

/// A context for the options' device, not yet connected. Link recovery of libmodbus stays off: it loops
/// for ever. Throws DeviceError when libmodbus refuses the options.
Context make_context(const ModbusOptions& options);

/// Grows from 0.1 s to 5 s; waits in rounds, so that a stop is noticed.
class Backoff {
 public:
  bool due() const;   ///< may the device be tried now?
  void wait() const;  ///< until due, at most one round of 0.2 s
  void failed();      ///< the next try comes after the pause, which doubles
  void worked();      ///< the next pause is short again

 private:
  std::int64_t next_ms_ = 0;
  std::int64_t pause_ms_ = 100;
};

std::int64_t monotonic_ms();

}  // namespace rigsound::modbus
