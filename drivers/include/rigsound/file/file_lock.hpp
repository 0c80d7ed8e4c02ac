// An advisory lock between processes.
#pragma once

#include <filesystem>

#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/file/unfinished.hpp"

namespace rigsound {

/// A lock on a file that is made for it and goes with the last that holds it. It ends with the object or the
/// process, kill -9 too. Errors: DeviceError when the file cannot be written. Thread: OFF, CT.
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
  bool lock(int operation);
  bool is_the_file() const;
  void remove_if_free() const;

  std::filesystem::path file_;
  FileDescriptor fd_;
  Unfinished unfinished_;
};

}  // namespace rigsound
