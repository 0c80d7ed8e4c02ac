#include "rigsound/file/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "file/nameless_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound {
namespace {

/// Rounded up: what is over a limit never reads as the limit.
std::string mebibytes(std::uintmax_t bytes) { return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB"; }

FileDescriptor copy_of_pipe(const FileDescriptor& from, const std::string& name, std::uintmax_t most_bytes) {
  FileDescriptor out = file::nameless_file();
  std::array<char, 1 << 16> buffer;
  for (std::uintmax_t bytes = 0;;) {
    const ssize_t got = ::read(from.get(), buffer.data(), buffer.size());
    if (got == 0) return out;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError(name, std::string("cannot be read: ") + std::strerror(errno));
    bytes += static_cast<std::uintmax_t>(got);
    if (bytes > most_bytes)
      throw InputError(name, "has more than " + mebibytes(most_bytes) + ", expected no more");
    file::add_to(out, buffer.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& file, std::string_view kind, std::uintmax_t most_bytes)
    : name_(file.string()), path_(file) {
  const bool standard_input = name_ == "-";
  if (standard_input) name_ = "standard input";
  const FileDescriptor fd(standard_input ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                                         : ::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd) throw InputError(name_, "cannot be opened, expected a readable " + std::string(kind));
  struct stat status {};
  const bool known = ::fstat(fd.get(), &status) == 0;
  if (known && S_ISDIR(status.st_mode))
    throw InputError(name_, "is a folder, expected a " + std::string(kind));
  const bool regular = known && S_ISREG(status.st_mode);
  if (regular && static_cast<std::uintmax_t>(status.st_size) > most_bytes)
    throw InputError(name_, "is of " + mebibytes(status.st_size) + ", expected a " + std::string(kind) +
                                " of at most " + mebibytes(most_bytes));
  if (!standard_input && regular) return;
  copy_ = copy_of_pipe(fd, name_, most_bytes);
  path_ = "/proc/self/fd/" + std::to_string(copy_.get());
}

std::string InputFile::content() const {
  std::ifstream in(path_, std::ios::binary | std::ios::ate);
  std::string bytes(in.is_open() ? static_cast<std::size_t>(in.tellg()) : 0, '\0');
  in.seekg(0).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in) throw InputError(name_, "cannot be read to its end");
  return bytes;
}

}  // namespace rigsound
