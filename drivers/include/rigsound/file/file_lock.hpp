// An advisory lock between processes.
#pragma once

#include <filesystem>

namespace rigsound {

/// A lock on a file that is made for it and stays. It ends with the object or the process, kill -9 too.
/// Errors: DeviceError when the file cannot be written. Thread: OFF, CT.
class FileLock {
 public:
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  void wait_exclusive();
  void wait_shared();
  [[nodiscard]] bool try_exclusive();

 private:
  int fd_;
};

}  // namespace rigsound
