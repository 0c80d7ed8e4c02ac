// What tells one recording from another: the hash of its bytes.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>

namespace rigsound::analysis {

/// Hashes a recording at most once, whichever of its parts asks first. Thread: OFF, any.
class SourceHash {
 public:
  explicit SourceHash(std::filesystem::path path) : path_(std::move(path)) {}

  /// Errors: InputError, the same for every part.
  std::string sha256();

 private:
  std::filesystem::path path_;
  std::mutex mutex_;
  std::string sha256_;
};

}  // namespace rigsound::analysis
