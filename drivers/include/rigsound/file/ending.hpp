// What a file's name says it is.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace rigsound {

/// The extension in small letters, with its dot: ".wav" of "A.WAV". Thread: any.
inline std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace rigsound
