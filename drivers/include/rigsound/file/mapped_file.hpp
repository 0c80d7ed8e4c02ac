// The bytes of a file, in memory only where they are looked at.
#pragma once

#include <filesystem>
#include <string_view>

namespace rigsound {

class MappedFile {
 public:
  /// Errors: InputError when it cannot be read. Thread: OFF.
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return {static_cast<const char*>(data_), size_}; }

  /// Gives memory back where bytes() are looked at no more; a second look reads the file again.
  /// `part`: of bytes().
  void forget(std::string_view part) const noexcept;

 private:
  void* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace rigsound
