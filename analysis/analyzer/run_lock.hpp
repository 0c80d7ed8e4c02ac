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

  /// Removes the folder again when nothing came into it and nobody else is at work.
  void remove_if_alone();

 private:
  std::filesystem::path sound_set_;
  FileLock lock_;
};

}  // namespace rigsound::analysis
