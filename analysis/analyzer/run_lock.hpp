// Several runs may fill one sound set at the same time.
#pragma once

#include <filesystem>

#include "rigsound/file/file_lock.hpp"
#include "rigsound/file/unfinished.hpp"

namespace rigsound::analysis {

/// A folder that is made if need be, and goes again with the object, or when a signal ends the program, if it
/// was made and nothing came into it. Errors: DeviceError. Thread: OFF.
class MadeFolder {
 public:
  explicit MadeFolder(const std::filesystem::path& folder);
  ~MadeFolder();

 private:
  void remove_if_empty() const;

  std::filesystem::path folder_;
  bool made_ = false;
  Unfinished unfinished_;
};

/// Held by a run as long as it writes banks. The first of several runs removes what killed ones left behind.
/// Errors: DeviceError. Thread: OFF.
class RunLock {
 public:
  explicit RunLock(const std::filesystem::path& sound_set);

 private:
  MadeFolder folder_;  // first: the lock's file lies in it
  FileLock lock_;
};

}  // namespace rigsound::analysis
