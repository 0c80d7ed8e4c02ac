#include "rigsound/file/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>

#include "file/flush.hpp"

namespace rigsound {
namespace fs = std::filesystem;

using file::fail;
using file::flush_to_disk;

AtomicFile::AtomicFile(fs::path target) : target_(std::move(target)) {
  // Renaming over a device such as /dev/null would remove it from the machine.
  std::error_code none;
  if (fs::exists(target_, none) && !fs::is_regular_file(target_, none))
    fail(target_, "is no regular file and cannot be replaced",
         fs::is_directory(target_, none) ? EISDIR : ENOTSUP);
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  std::string name = (folder / ("." + target_.stem().string() + ".XXXXXX")).string();
  const std::string extension = target_.extension().string();
  name += extension;
  const int fd = ::mkstemps(name.data(), static_cast<int>(extension.size()));
  if (fd < 0) fail(target_, "cannot be written", errno);
  ::fchmod(fd, 0644);
  ::close(fd);
  temporary_ = name;
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  flush_to_disk(temporary_);
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(target_, "cannot be put in place", error.value());
  committed_ = true;
}

void write_file(const fs::path& target, std::string_view text) {
  AtomicFile file(target);
  std::ofstream out(file.temporary(), std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) fail(target, "cannot be written", errno);
  file.commit();
}

}  // namespace rigsound
