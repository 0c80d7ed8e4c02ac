// Room for what does not fit into memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound {

/// A temporary file without a name: nobody can leave it behind. Thread: OFF, any.
class ScratchFile {
 public:
  /// In the folder for temporary files (TMPDIR). Errors: DeviceError.
  ScratchFile();

  /// Returns where the bytes lie. Errors: DeviceError when there is no room.
  std::uint64_t append(const void* bytes, std::size_t size);

  /// What was appended. Errors: DeviceError.
  void read(std::uint64_t at, void* bytes, std::size_t size) const;

 private:
  FileDescriptor file_;
  std::mutex writing_;
  std::uint64_t end_ = 0;
};

}  // namespace rigsound
