#include "rigsound/file/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "file/flush.hpp"

namespace rigsound {
namespace {

void wait(int fd, int operation) {
  while (::flock(fd, operation) != 0 && errno == EINTR) {
  }
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file)
    : fd_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (fd_ < 0) rigsound::file::fail(file, "cannot be written", errno);
}
FileLock::~FileLock() { ::close(fd_); }

void FileLock::wait_exclusive() { wait(fd_, LOCK_EX); }
void FileLock::wait_shared() { wait(fd_, LOCK_SH); }
bool FileLock::try_exclusive() { return ::flock(fd_, LOCK_EX | LOCK_NB) == 0; }

}  // namespace rigsound
