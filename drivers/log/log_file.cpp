#include "rigsound/log/log_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

struct CloseGz {
  void operator()(gzFile file) const { ::gzclose(file); }
};
using GzFile = std::unique_ptr<gzFile_s, CloseGz>;

bool is_regular(int fd) {
  struct stat s {};
  return ::fstat(fd, &s) == 0 && S_ISREG(s.st_mode);
}

bool is_folder(int fd) {
  struct stat s {};
  return ::fstat(fd, &s) == 0 && S_ISDIR(s.st_mode);
}

bool is_packed(int fd) {
  unsigned char magic[2] = {};
  return ::pread(fd, magic, sizeof magic, 0) == sizeof magic && magic[0] == 0x1f && magic[1] == 0x8b;
}

FileDescriptor nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "rigsound.log.XXXXXX").string();
  FileDescriptor fd(::mkostemp(name.data(), O_CLOEXEC));
  if (!fd) throw DeviceError(name + ": cannot be written: " + std::strerror(errno));
  ::unlink(name.c_str());
  return fd;
}

void write_all(int fd, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t wrote = ::write(fd, bytes, size);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) throw DeviceError(std::string("no room for a copy of the log: ") + std::strerror(errno));
    bytes += wrote;
    size -= static_cast<std::size_t>(wrote);
  }
}

/// Everything that `from` has, unpacked where it is packed.
FileDescriptor copy_of(const FileDescriptor& from, const std::string& name) {
  const GzFile in(::gzdopen(::fcntl(from.get(), F_DUPFD_CLOEXEC, 3), "rb"));
  if (!in) throw InputError(name, "cannot be read");
  FileDescriptor out = nameless_file();
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const int got = ::gzread(in.get(), buffer.data(), buffer.size());
    if (got > 0) write_all(out.get(), buffer.data(), static_cast<std::size_t>(got));
    if (got == static_cast<int>(buffer.size())) continue;
    int error = Z_OK;
    const char* const why = ::gzerror(in.get(), &error);
    if (got < 0 || error == Z_BUF_ERROR)
      throw InputError(name, std::string("cannot be unpacked to its end: ") + why);
    if (got == 0) return out;
  }
}

}  // namespace

LogFile::LogFile(const std::filesystem::path& file) : name_(file.string()), path_(file) {
  const bool standard_input = name_ == "-";
  if (standard_input) name_ = "standard input";
  FileDescriptor fd(standard_input ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                                   : ::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd) throw InputError(name_, "cannot be opened, expected a readable bus log");
  if (is_folder(fd.get())) throw InputError(name_, "is a folder, expected a bus log");
  if (!standard_input && is_regular(fd.get()) && !is_packed(fd.get())) return;
  copy_ = copy_of(fd, name_);
  path_ = "/proc/self/fd/" + std::to_string(copy_.get());
}

}  // namespace rigsound::log
