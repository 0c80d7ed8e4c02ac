// What lies at a path, in a word.
#pragma once

#include <filesystem>
#include <string_view>

namespace rigsound {

/// "a file", "a folder", "a link", "a device", "a pipe", "a socket"; empty: nothing is there. Thread: any.
constexpr std::string_view kind_word(std::filesystem::file_type type) {
  switch (type) {
    case std::filesystem::file_type::none:
    case std::filesystem::file_type::not_found:
      return "";
    case std::filesystem::file_type::directory:
      return "a folder";
    case std::filesystem::file_type::symlink:
      return "a link";
    case std::filesystem::file_type::block:
    case std::filesystem::file_type::character:
      return "a device";
    case std::filesystem::file_type::fifo:
      return "a pipe";
    case std::filesystem::file_type::socket:
      return "a socket";
    default:
      return "a file";
  }
}

}  // namespace rigsound
