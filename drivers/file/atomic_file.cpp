#include "rigsound/file/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <string>

#include "file/flush.hpp"
#include "rigsound/file/file_descriptor.hpp"

namespace rigsound {
namespace fs = std::filesystem;

using file::fail;
using file::flush_to_disk;

namespace {

/// Renaming over a device such as /dev/null would remove it from the machine.
bool cannot_be_replaced(const fs::path& target) {
  std::error_code none;
  const std::string name = target.string();
  return is_standard_output(target) || name.rfind("/dev/fd/", 0) == 0 || name.rfind("/proc/", 0) == 0 ||
         (fs::exists(target, none) && fs::is_other(target, none));
}

void copy_into(const fs::path& target, const fs::path& from) {
  const FileDescriptor in(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
  const FileDescriptor out(is_standard_output(target) ? ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3)
                                                      : ::open(target.c_str(), O_WRONLY | O_CLOEXEC));
  if (!in || !out) fail(target, "cannot be written", errno);
  std::array<char, 1 << 16> bytes;
  for (;;) {
    const ssize_t got = ::read(in.get(), bytes.data(), bytes.size());
    if (got < 0) fail(from, "cannot be read again", errno);
    if (got == 0) return;
    file::write_all(out.get(), bytes.data(), static_cast<std::size_t>(got),
                    target.string() + ": cannot be written");
  }
}

}  // namespace

bool is_standard_output(const fs::path& target) {
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
    if (target == name) return true;
  return false;
}

AtomicFile::AtomicFile(fs::path target)
    : target_(std::move(target)), place_(file::behind_links(target_)), copied_(cannot_be_replaced(target_)) {
  std::error_code none;
  if (fs::is_directory(target_, none)) fail(target_, "is a folder and cannot be replaced", EISDIR);
  const fs::path beside = place_.has_parent_path() ? place_.parent_path() : fs::path(".");
  const fs::path folder = copied_ ? fs::temp_directory_path() : beside;
  const std::string extension = place_.extension().string();
  std::string name = (folder / ("." + place_.stem().string() + ".XXXXXX" + extension)).string();
  unfinished_ = std::make_unique<Unfinished>([&] {
    const int fd = ::mkstemps(name.data(), static_cast<int>(extension.size()));
    if (fd < 0) fail(target_, "cannot be written", errno);
    ::fchmod(fd, 0644);
    ::close(fd);
    temporary_ = name;
    return [name] { ::unlink(name.c_str()); };
  });
}

AtomicFile::~AtomicFile() {
  if (unfinished_) ::unlink(temporary_.c_str());
}

void AtomicFile::commit() {
  if (copied_) return copy_into(target_, temporary_);
  flush_to_disk(temporary_);
  std::error_code error;
  fs::rename(temporary_, place_, error);
  if (error) fail(target_, "cannot be put in place", error.value());
  unfinished_.reset();
}

void write_file(const fs::path& target, std::string_view text) {
  AtomicFile file(target);
  // Empty, and never made anew: a signal may just have taken it away.
  std::ofstream out(file.temporary(), std::ios::in | std::ios::out | std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) fail(target, "cannot be written", errno);
  file.commit();
}

}  // namespace rigsound
