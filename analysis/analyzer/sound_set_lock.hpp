// Several runs may fill one sound set at the same time.
#pragma once

#include <filesystem>

namespace rigsound::analysis {

/// An advisory lock on SET/NAME that ends with the object or the process. Errors: DeviceError. Thread: OFF.
class FolderLock {
 public:
  FolderLock(const std::filesystem::path& sound_set, const char* name);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  void wait_exclusive();
  void wait_shared();
  [[nodiscard]] bool try_exclusive();

 private:
  int fd_;
};

/// Held by a run as long as it writes banks. The first of several runs removes what killed ones left behind.
class RunLock {
 public:
  explicit RunLock(const std::filesystem::path& sound_set);

 private:
  FolderLock lock_;
};

}  // namespace rigsound::analysis
