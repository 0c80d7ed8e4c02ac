#include "rigsound/file/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound {

MappedFile::MappedFile(const std::filesystem::path& file) {
  const auto fail = [&] {
    throw InputError(file.string(), std::string("cannot be read: ") + std::strerror(errno));
  };
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!descriptor || ::fstat(descriptor.get(), &status) != 0) fail();
  if (!S_ISREG(status.st_mode))
    throw InputError(file.string(), "is no regular file, expected one on disk: it is read in any order");
  size_ = static_cast<std::size_t>(status.st_size);
  if (size_ == 0) return;
  data_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor.get(), 0);
  if (data_ == MAP_FAILED) fail();
}

MappedFile::~MappedFile() {
  if (size_ > 0) ::munmap(data_, size_);
}

void MappedFile::forget(std::string_view part) const noexcept {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const auto first = static_cast<std::size_t>(part.data() - bytes().data());
  const std::size_t from = (first + page - 1) / page * page, to = (first + part.size()) / page * page;
  if (from < to) ::madvise(static_cast<char*>(data_) + from, to - from, MADV_DONTNEED);
}

}  // namespace rigsound
