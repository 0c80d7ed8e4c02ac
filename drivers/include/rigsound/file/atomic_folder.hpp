// A folder that is either whole or not there: filled under a temporary name, then renamed.
#pragma once

#include <filesystem>
#include <memory>

#include "rigsound/file/unfinished.hpp"
#include "rigsound/progress.hpp"

namespace rigsound {

/// Makes a temporary folder beside `target`, and the parents of both. Unless commit() or join() was called
/// the temporary is removed on destruction, or when a signal ends the program, and `target` stays as it was.
/// Errors: DeviceError when the folder cannot be written. Thread: OFF, CT.
class AtomicFolder {
 public:
  explicit AtomicFolder(const std::filesystem::path& target);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  /// Where to write the files.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Flushes every file to disk and puts the folder in place of the target, old content and all. `progress`:
  /// of the flushing.
  void commit(const Progress& progress = {});

  /// Flushes every file to disk and moves it into the target, which keeps what else is in it.
  void join();

 private:
  std::filesystem::path target_, temporary_;
  std::unique_ptr<Unfinished> unfinished_;
};

}  // namespace rigsound
