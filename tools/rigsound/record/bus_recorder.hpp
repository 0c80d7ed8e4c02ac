// Records every bus of a rig until told to stop.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "rigsound/config/rig.hpp"

namespace rigsound::tools {

/// Runs in threads of its own from construction to destruction.
class BusRecorder {
 public:
  virtual ~BusRecorder() = default;
  virtual void flush() = 0;  ///< what came so far is on its way to the disk
  virtual std::uint64_t entries() const = 0;
};

/// All frames of all CAN interfaces of the rig, as candump -l writes them. Errors: DeviceError.
std::unique_ptr<BusRecorder> record_can(const config::Rig& rig, const std::filesystem::path& file);

/// All exchanges of all Modbus buses of the rig, as a capture; each plays its part (client or server)
/// while it is recorded. Errors: DeviceError.
std::unique_ptr<BusRecorder> record_modbus(const config::Rig& rig, const std::filesystem::path& file);

/// All datagrams of all UDP inputs of the rig, as a capture. Errors: DeviceError.
std::unique_ptr<BusRecorder> record_udp(const config::Rig& rig, const std::filesystem::path& file);

}  // namespace rigsound::tools
