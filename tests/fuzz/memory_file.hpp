// Bytes as a file that readers can open, in memory only.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::fuzz {

class MemoryFile {
 public:
  MemoryFile(const void* data, std::size_t size) : fd_(::memfd_create("fuzz", 0)) {
    if (!fd_ || ::write(fd_.get(), data, size) != static_cast<ssize_t>(size)) std::abort();
  }
  explicit MemoryFile(const std::string& text) : MemoryFile(text.data(), text.size()) {}

  int descriptor() const { return fd_.get(); }
  std::string path() const { return "/proc/self/fd/" + std::to_string(fd_.get()); }
  std::string content() const {
    std::string bytes(static_cast<std::size_t>(::lseek(fd_.get(), 0, SEEK_END)), '\0');
    if (::pread(fd_.get(), bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) std::abort();
    return bytes;
  }

 private:
  FileDescriptor fd_;
};

/// Runs a reader that may refuse what it reads with `Refusal`, which must say something. Whether it did not.
template <class Refusal, class Read>
bool accepts(Read read) {
  try {
    read();
    return true;
  } catch (const Refusal& refusal) {
    if (*refusal.what() == '\0') std::abort();
    return false;
  }
}

}  // namespace rigsound::fuzz
