// A CAN interface as it is in a cabin: there, down, gone, back again.
#pragma once

#include <memory>

#include "rigsound/bus/bus.hpp"
#include "rigsound/can/can_options.hpp"
#include "rigsound/can/frame.hpp"

namespace rigsound::can {

using CanTap = BusTap<Arrival>;  ///< data frames

/// Opens the interface, reads it, and opens it again after every loss: when the kernel reports a change of
/// links, at the latest after the pause. The kernel passes the messages of the routes and controller errors
/// only; with a tap all data frames. Thread: OFF.
std::unique_ptr<Bus> make_bus(const CanOptions& options, BusListener& listener, CanTap* tap = nullptr);

}  // namespace rigsound::can
