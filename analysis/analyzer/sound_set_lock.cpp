#include "analyzer/sound_set_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "rigsound/device_error.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

/// Banks are filled under a name with a leading dot and renamed when they are whole.
void remove_unfinished(const fs::path& banks) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(banks, error))
    if (entry.path().filename().string()[0] == '.') fs::remove_all(entry.path(), error);
}

void wait(int fd, int operation) {
  while (::flock(fd, operation) != 0 && errno == EINTR) {
  }
}

}  // namespace

FolderLock::FolderLock(const fs::path& sound_set, const char* name) {
  const fs::path file = sound_set / name;
  fd_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd_ < 0) throw DeviceError(file.string() + ": cannot be written: " + std::strerror(errno));
}
FolderLock::~FolderLock() { ::close(fd_); }

void FolderLock::wait_exclusive() { wait(fd_, LOCK_EX); }
void FolderLock::wait_shared() { wait(fd_, LOCK_SH); }
bool FolderLock::try_exclusive() { return ::flock(fd_, LOCK_EX | LOCK_NB) == 0; }

RunLock::RunLock(const fs::path& sound_set) : lock_(sound_set, ".run.lock") {
  if (lock_.try_exclusive()) remove_unfinished(sound_set / "banks");
  lock_.wait_shared();
}

}  // namespace rigsound::analysis
