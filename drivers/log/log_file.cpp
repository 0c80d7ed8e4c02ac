#include "rigsound/log/log_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <memory>

#include "file/nameless_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

struct CloseGz {
  void operator()(gzFile file) const { ::gzclose(file); }
};
using GzFile = std::unique_ptr<gzFile_s, CloseGz>;

bool is_packed(const std::filesystem::path& file) {
  const FileDescriptor fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  unsigned char magic[2] = {};
  return fd && ::pread(fd.get(), magic, sizeof magic, 0) == sizeof magic && magic[0] == 0x1f &&
         magic[1] == 0x8b;
}

FileDescriptor unpacked(const std::filesystem::path& packed, const std::string& name) {
  const GzFile in(::gzopen(packed.c_str(), "rbe"));
  if (!in) throw InputError(name, "cannot be read");
  FileDescriptor out = file::nameless_file();
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const int got = ::gzread(in.get(), buffer.data(), buffer.size());
    if (got > 0) file::add_to(out, buffer.data(), static_cast<std::size_t>(got));
    if (got == static_cast<int>(buffer.size())) continue;
    int error = Z_OK;
    const char* const why = ::gzerror(in.get(), &error);
    if (got < 0 || error == Z_BUF_ERROR)
      throw InputError(name, std::string("cannot be unpacked to its end: ") + why);
    if (got == 0) return out;
  }
}

}  // namespace

LogFile::LogFile(const std::filesystem::path& file) : file_(file, "bus log"), path_(file_.path()) {
  if (!is_packed(path_)) return;
  unpacked_ = unpacked(path_, name());
  path_ = "/proc/self/fd/" + std::to_string(unpacked_.get());
}

std::uintmax_t LogFile::bytes() const {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path_, unknown);
  return unknown ? 0 : size;
}

}  // namespace rigsound::log
