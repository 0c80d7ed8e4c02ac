#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/file/large_block.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound {

LargeBlock read_block(const std::filesystem::path& file) {
  const auto fail = [&] {
    throw InputError(file.string(), std::string("cannot be read: ") + std::strerror(errno));
  };
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!descriptor || ::fstat(descriptor.get(), &status) != 0) fail();
  if (!S_ISREG(status.st_mode)) throw InputError(file.string(), "is no regular file, expected one on disk");
  LargeBlock block(static_cast<std::size_t>(status.st_size));
  for (std::size_t at = 0; at < block.size();) {
    const ssize_t got = ::read(descriptor.get(), block.data() + at, block.size() - at);
    if (got == 0) throw InputError(file.string(), "became shorter while it was read");
    if (got < 0 && errno != EINTR) fail();
    if (got > 0) at += static_cast<std::size_t>(got);
  }
  return block;
}

}  // namespace rigsound
