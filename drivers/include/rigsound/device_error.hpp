// The one way a driver says that the machine failed us: a device, the disk, a bus.
#pragma once

#include <stdexcept>

namespace rigsound {

/// what() is the one line a user sees, naming the device and the fix. Programs end with exit code 3.
/// Thread: OFF, CT; never thrown on the audio thread.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rigsound
