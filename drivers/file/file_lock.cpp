#include "rigsound/file/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "file/flush.hpp"

namespace rigsound {
namespace {

FileDescriptor open_lock(const std::filesystem::path& file) {
  FileDescriptor fd(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!fd) rigsound::file::fail(file, "cannot be written", errno);
  return fd;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file)
    : file_(file), unfinished_([this] {
        fd_ = open_lock(file_);
        return [this] { remove_if_free(); };
      }) {}
FileLock::~FileLock() { remove_if_free(); }

void FileLock::wait_exclusive() { lock(LOCK_EX); }
void FileLock::wait_shared() { lock(LOCK_SH); }
bool FileLock::try_exclusive() { return lock(LOCK_EX | LOCK_NB); }

/// Once more when the file was removed, by its last holder, before it was ours.
bool FileLock::lock(int operation) {
  for (;;) {
    while (::flock(fd_.get(), operation) != 0)
      if (errno != EINTR) return false;
    if (is_the_file()) return true;
    fd_ = open_lock(file_);
  }
}

bool FileLock::is_the_file() const {
  struct stat ours {
  }, named{};
  return ::fstat(fd_.get(), &ours) == 0 && ::stat(file_.c_str(), &named) == 0 &&
         ours.st_dev == named.st_dev && ours.st_ino == named.st_ino;
}

void FileLock::remove_if_free() const {
  if (::flock(fd_.get(), LOCK_EX | LOCK_NB) == 0 && is_the_file()) ::unlink(file_.c_str());
}

}  // namespace rigsound
