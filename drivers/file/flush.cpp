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

void flush_to_disk(const std::filesystem::path& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) fail(path, "cannot be opened again", errno);
  const int synced = ::fsync(fd);
  const int error = errno;
  ::close(fd);
  if (synced != 0) fail(path, "cannot be flushed to disk", error);
}

std::filesystem::path behind_links(const std::filesystem::path& target) {
  std::error_code error;
  if (!std::filesystem::is_symlink(target, error)) return target;
  const std::filesystem::path place = std::filesystem::weakly_canonical(target, error);
  return error ? target : place;
}

}  // namespace rigsound::file
