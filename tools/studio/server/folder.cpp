#include "folder.hpp"

#include <unistd.h>

#include <algorithm>

#include "http.hpp"
#include "rigsound/config/sha256.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/input_file.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostVersioned = 64 << 20;

std::string digits_of(const std::string& bytes, std::size_t count) {
  config::Sha256 hash;
  hash.update(bytes.data(), bytes.size());
  return hash.hex().substr(0, count);
}

bool begins_with(const fs::path& path, const fs::path& start) {
  return std::mismatch(start.begin(), start.end(), path.begin(), path.end()).first == start.end();
}

}  // namespace

bool Folder::holds(const fs::path& file) const {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(path_, error);
  if (error) return false;
  if (fs::is_symlink(file, error) && !fs::exists(file, error))
    return false;  // nobody knows where it will lead
  const fs::path place = fs::weakly_canonical(file, error);
  return !error && begins_with(place, folder);
}

fs::path Folder::inside(const fs::path& relative) const {
  fs::path file = path_ / relative;
  if (!holds(file)) throw ApiError(403, relative.string() + ": leads out of the folder");
  return file;
}

bool Folder::writable() const {
  std::error_code error;
  const fs::path folder = fs::absolute(path_, error);
  const fs::path& place = fs::exists(folder, error) ? folder : folder.parent_path();
  return ::access(place.c_str(), W_OK) == 0;
}

std::string version_of_text(const std::string& text) { return digits_of(text, 16); }

std::string version_of(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return kAbsentVersion;
  return version_of_text(InputFile(file, "file", kMostVersioned).content());
}

void require_version(const fs::path& file, const std::string& seen) {
  const std::string version = version_of(file);
  if (version != seen)
    throw ApiError(409, file.filename().string() + ": has changed since it was read", {{"version", version}});
}

void replace_keeping_last(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (fs::exists(file, error))
    write_file(file.string() + ".bak", InputFile(file, "file", kMostVersioned).content());
  if (!text.empty()) return write_file(file, text);
  fs::remove(file, error);
  if (error) throw DeviceError(file.string() + ": cannot be removed: " + error.message());
}

std::string id_of(const std::string& name) { return digits_of(name, 12); }

}  // namespace rigsound::studio
