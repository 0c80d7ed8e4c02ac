#include "rigsound/file/scratch_file.hpp"

#include <unistd.h>

#include <cerrno>

#include "file/flush.hpp"
#include "file/nameless_file.hpp"

namespace rigsound {

ScratchFile::ScratchFile() : file_(file::nameless_file()) {}

std::uint64_t ScratchFile::append(const void* bytes, std::size_t size) {
  const std::lock_guard<std::mutex> lock(writing_);
  file::write_all(file_.get(), static_cast<const char*>(bytes), size, "no room for a temporary file");
  const std::uint64_t at = end_;
  end_ += size;
  return at;
}

void ScratchFile::read(std::uint64_t at, void* bytes, std::size_t size) const {
  for (std::size_t done = 0; done < size;) {
    const ssize_t got =
        ::pread(file_.get(), static_cast<char*>(bytes) + done, size - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) file::fail("temporary file", "cannot be read back", got < 0 ? errno : EIO);
    done += static_cast<std::size_t>(got);
  }
}

}  // namespace rigsound
