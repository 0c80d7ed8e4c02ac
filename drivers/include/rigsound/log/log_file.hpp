// A recorded bus as a file that can be read from its start as often as it takes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/file/input_file.hpp"

namespace rigsound::log {

/// An InputFile; what gzip packed is first unpacked into a temporary file without a name. Thread: OFF.
class LogFile {
 public:
  /// Errors: InputError for what cannot be opened, is a folder or is damaged; DeviceError when there is no
  /// room.
  explicit LogFile(const std::filesystem::path& file);

  const std::string& name() const { return file_.name(); }     ///< for messages
  const std::filesystem::path& path() const { return path_; }  ///< to be opened while this lives
  std::uintmax_t bytes() const;                                ///< how long it is, unpacked; 0: not known

 private:
  InputFile file_;
  std::filesystem::path path_;
  FileDescriptor unpacked_;
};

/// Of a file of `bytes`, `read` of which were read; 1 when its length is not known.
inline double share_of(std::uintmax_t read, std::uintmax_t bytes) {
  return read < bytes ? static_cast<double>(read) / static_cast<double>(bytes) : 1;
}

}  // namespace rigsound::log
