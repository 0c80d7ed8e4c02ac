// OSC over UDP: signals as readings of a bus, controls and mute to who sets them.
#pragma once

#include <memory>

#include "rigsound/bus/bus.hpp"
#include "rigsound/osc/osc_options.hpp"

namespace rigsound::osc {

/// Told what is no signal, from the thread that runs the bus.
class ControlListener {
 public:
  virtual ~ControlListener() = default;
  virtual void control(int boom, const ControlInfo& control, double value) = 0;  ///< a value that it takes
  virtual void mute(bool on) = 0;
};

/// Listens at options.address; a port that is taken is tried again after pauses. Thread: OFF.
std::unique_ptr<Bus> make_bus(const OscOptions& options, BusListener& listener, ControlListener& controls);

}  // namespace rigsound::osc
