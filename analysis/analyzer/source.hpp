// One recording file while its parts are analysed.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "rigsound/analysis/recording.hpp"

namespace rigsound::analysis {

/// Reads and hashes a file at most once, whichever part asks first, and lets go of it after its last part.
/// Thread: OFF, any.
class Source {
 public:
  /// `parts` calls of finish_part() free the samples.
  Source(std::filesystem::path path, int parts) : path_(std::move(path)), parts_left_(parts) {}

  /// SHA-256 of the file's bytes, 64 hex digits. Errors: InputError.
  std::string sha256();
  /// Errors: InputError, the same for every part.
  std::shared_ptr<const Recording> recording();
  void finish_part();

 private:
  std::filesystem::path path_;
  std::mutex mutex_;
  int parts_left_;
  std::string sha256_;
  std::shared_ptr<const Recording> recording_;
};

/// SHA-256 of a file's bytes, 64 hex digits. Errors: InputError when it cannot be read. Thread: OFF.
std::string file_sha256(const std::filesystem::path& path);

}  // namespace rigsound::analysis
