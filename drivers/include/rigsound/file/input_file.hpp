// An input as a file that can be read from its start as often as it takes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound {

/// A regular file is read where it lies. Standard input (`-`) and a pipe are first copied into a temporary
/// file without a name. Thread: OFF.
class InputFile {
 public:
  static constexpr std::uintmax_t kAnySize = UINTMAX_MAX;

  /// `kind`: what it should be, such as "bus log", of at most `most_bytes`. Errors: InputError for what
  /// cannot be opened, is a folder or is larger; DeviceError when there is no room.
  InputFile(const std::filesystem::path& file, std::string_view kind, std::uintmax_t most_bytes = kAnySize);

  const std::string& name() const { return name_; }            ///< for messages
  const std::filesystem::path& path() const { return path_; }  ///< to be opened while this lives

  std::string content() const;  ///< all of it; errors: InputError when it cannot be read to its end

 private:
  std::string name_;
  std::filesystem::path path_;
  FileDescriptor copy_;
};

}  // namespace rigsound
