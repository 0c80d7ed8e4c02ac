#include "file/nameless_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "file/flush.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::file {

FileDescriptor nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "rigsound.XXXXXX").string();
  FileDescriptor fd(::mkostemp(name.data(), O_CLOEXEC));
  if (!fd) fail(name, "cannot be written", errno);
  ::unlink(name.c_str());
  return fd;
}

void write_all(int fd, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t wrote = ::write(fd, bytes, size);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) throw DeviceError(std::string("no room for a copy of the input: ") + std::strerror(errno));
    bytes += wrote;
    size -= static_cast<std::size_t>(wrote);
  }
}

}  // namespace rigsound::file
