// A folder that nothing leaves: the only way from names to paths. Thread: any.
#pragma once

#include <filesystem>
#include <string>

namespace rigsound::studio {

class Folder {
 public:
  /// It may be made later.
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }

  /// `relative` below the folder, whether it is there or not. Errors: ApiError 403 when the path leaves the
  /// folder, by
  /// `..` or by a link.
  std::filesystem::path inside(const std::filesystem::path& relative) const;

  bool holds(const std::filesystem::path& file) const;  ///< whether a path, links followed, lies in it
  bool writable() const;

 private:
  std::filesystem::path path_;
};

/// A file's bytes as an opaque word; "absent" when there is none. Errors: InputError when it cannot be read.
std::string version_of(const std::filesystem::path& file);
std::string version_of_text(const std::string& text);

constexpr const char* kAbsentVersion = "absent";

/// Errors: ApiError 409, with the version that the file has, when it is not the one that was `seen`.
void require_version(const std::filesystem::path& file, const std::string& seen);

/// Replaces `file`, whole or not at all, and keeps what was there as FILE.bak; an empty `text` removes it.
/// Errors: DeviceError; the file is then as it was.
void replace_keeping_last(const std::filesystem::path& file, const std::string& text);

/// A random or a running number cannot be had from a name: the first digits of its hash can. Letters and
/// digits.
std::string id_of(const std::string& name);

}  // namespace rigsound::studio
