#include "rigsound/file/atomic_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include "file/flush.hpp"

namespace rigsound {
namespace fs = std::filesystem;

using file::fail;
using file::flush_to_disk;

AtomicFolder::AtomicFolder(fs::path target) : target_(std::move(target)) {
  const fs::path parent = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  std::error_code error;
  fs::create_directories(parent, error);
  if (error) fail(parent, "cannot be made", error.value());
  std::string name = (parent / ("." + target_.filename().string() + ".XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) fail(target_, "cannot be written", errno);
  ::chmod(name.c_str(), 0755);
  temporary_ = name;
}

AtomicFolder::~AtomicFolder() {
  std::error_code ignored;
  fs::remove_all(temporary_, ignored);
}

void AtomicFolder::commit() {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(temporary_))
    if (entry.is_regular_file()) flush_to_disk(entry.path());
  // After an exchange the temporary name holds the old content, which the destructor removes.
  if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) return;
  std::error_code error;
  if (errno != ENOENT) fs::remove_all(target_, error);  // file systems without exchange
  fs::rename(temporary_, target_, error);
  if (error) fail(target_, "cannot be put in place", error.value());
}

}  // namespace rigsound
