// Real recordings and logs, which are not part of the project.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace rigsound::tests {

/// `file` inside the folder that the environment variable RIGSOUND_TEST_DATA names; none, and says that
/// `test` is skipped, when the variable is not set or the file is not there.
inline std::optional<std::filesystem::path> test_data(const char* test, const char* file) {
  const char* folder = std::getenv("RIGSOUND_TEST_DATA");
  if (folder == nullptr) {
    std::printf("SKIPPED: %s: RIGSOUND_TEST_DATA is not set\n", test);
    return std::nullopt;
  }
  const std::filesystem::path path = std::filesystem::path(folder) / file;
  if (std::filesystem::exists(path)) return path;
  std::printf("SKIPPED: %s: %s is not there\n", test, path.c_str());
  return std::nullopt;
}

}  // namespace rigsound::tests
