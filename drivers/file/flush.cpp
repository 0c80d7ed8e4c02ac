#include "file/flush.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "rigsound/device_error.hpp"

namespace rigsound::file {

void fail(const std::filesystem::path& path, const char* what, int error) {
  throw DeviceError(path.string() + ": " + what + ": " + std::strerror(error));
}

void write_all(int fd, const char* bytes, std::size_t size, const std::string& what) {
  while (size > 0) {
    const ssize_t wrote = ::write(fd, bytes, size);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) throw DeviceError(what + ": " + std::strerror(errno));
    bytes += wrote;
    size -= static_cast<std::size_t>(wrote);
  }
}

void flush_to_disk(const std::filesystem::path& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) fail(path, "cannot be opened again", errno);
  const int synced = ::fsync(fd);
  const int error = errno;
  ::close(fd);
  if (synced != 0) fail(path, "cannot be flushed to disk", error);
}

std::filesystem::path behind_links(const std::filesystem::path& target) {
  constexpr int kMostLinks = 40;  // as the system follows
  std::error_code error;
  std::filesystem::path place = target;
  for (int links = 0; links < kMostLinks && std::filesystem::is_symlink(place, error); ++links)
    place =
        place.parent_path() / std::filesystem::read_symlink(place, error);  // an absolute one replaces all
  return place;
}

}  // namespace rigsound::file
