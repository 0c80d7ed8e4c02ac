// Several runs may fill one sound set at the same time.
#pragma once

#include <filesystem>

#include "rigsound/file/file_lock.hpp"

namespace rigsound::analysis {

/// Held by a run as long as it writes banks. The first of several runs removes what killed ones left behind.
/// Errors: DeviceError. Thread: OFF.
class RunLock {
 public:
  explicit RunLock(const std::filesystem::path& sound_set);

 private:
  FileLock lock_;
};

}  // namespace rigsound::analysis
