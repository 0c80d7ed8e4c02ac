#include "file/nameless_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "file/flush.hpp"

namespace rigsound::file {

FileDescriptor nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "rigsound.XXXXXX").string();
  FileDescriptor fd(::mkostemp(name.data(), O_CLOEXEC));
  if (!fd) fail(name, "cannot be written", errno);
  ::unlink(name.c_str());
  return fd;
}

void add_to(const FileDescriptor& nameless, const char* bytes, std::size_t size) {
  write_all(nameless.get(), bytes, size, "no room for a copy of the input");
}

}  // namespace rigsound::file
