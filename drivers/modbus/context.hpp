// A libmodbus context that frees itself.
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

/// Whether a device has answered, with an exception: what libmodbus leaves in errno.
inline bool is_exception(int error) { return error >= EMBXILFUN && error <= EMBXGTAR; }

/// A context for the options' device, not yet connected. Link recovery of libmodbus stays off: it loops
/// for ever. Throws DeviceError when libmodbus refuses the options.
Context make_context(const ModbusOptions& options);

}  // namespace rigsound::modbus
