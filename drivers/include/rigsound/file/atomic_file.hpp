// A file that is either whole or not there: written under a temporary name, then renamed.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "rigsound/file/unfinished.hpp"

namespace rigsound {

/// Whether a name means standard output: `-`, or what the system calls it. Thread: any.
bool is_standard_output(const std::filesystem::path& target);

/// Reserves a temporary name beside `target` (same folder, so that the rename is atomic), or beside the file
/// that a link of that name leads to. Unless commit() was called the temporary is removed on destruction, or
/// when a signal ends the program, and `target` stays as it was. Standard output, a pipe and a device are not
/// replaced: the whole content is copied into them. Errors: DeviceError when the folder cannot be written or
/// `target` is a folder. Thread: OFF, CT.
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
  std::filesystem::path target_, place_, temporary_;  // place_: the target behind links
  bool copied_;                                       // into what cannot be replaced
  std::unique_ptr<Unfinished> unfinished_;
};

/// Writes `text` as the whole of `target`, atomically.
void write_file(const std::filesystem::path& target, std::string_view text);

}  // namespace rigsound
