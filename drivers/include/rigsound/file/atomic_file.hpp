// A file that is either whole or not there: written under a temporary name, then renamed.
#pragma once

#include <filesystem>
#include <string_view>

namespace rigsound {

/// Reserves a temporary name beside `target` (same folder, so that the rename is atomic). Unless
/// commit() was called the temporary is removed on destruction and `target` stays as it was.
/// Errors: DeviceError when the folder cannot be written or `target` is a folder, a device or a pipe. Thread:
/// OFF, CT.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& target() const { return target_; }

  /// Where to write. Keeps the extension of the target, which some libraries look at.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Flushes to disk and renames over the target.
  void commit();

 private:
  std::filesystem::path target_, temporary_;
  bool committed_ = false;
};

/// Writes `text` as the whole of `target`, atomically.
void write_file(const std::filesystem::path& target, std::string_view text);

}  // namespace rigsound
