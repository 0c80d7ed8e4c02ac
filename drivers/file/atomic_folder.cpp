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

namespace {

/// Once more when another thread has put a file into it meanwhile.
void remove_folder(const fs::path& folder) {
  std::error_code error;
  for (int tries = 0; tries < 100 && fs::exists(folder, error); ++tries) fs::remove_all(folder, error);
}

template <class Each>
void for_each_file(const fs::path& folder, Each each) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) each(entry.path());
}

}  // namespace

AtomicFolder::AtomicFolder(const fs::path& target)
    : target_(file::behind_links(target.has_filename() ? target : target.parent_path())) {
  const fs::path parent = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  std::error_code error;
  fs::create_directories(parent, error);
  if (error) fail(parent, "cannot be made", error.value());
  std::string name = (parent / ("." + target_.filename().string() + ".XXXXXX")).string();
  unfinished_ = std::make_unique<Unfinished>([&] {
    if (::mkdtemp(name.data()) == nullptr) fail(target_, "cannot be written", errno);
    ::chmod(name.c_str(), 0755);
    temporary_ = name;
    return [folder = temporary_] { remove_folder(folder); };
  });
}

AtomicFolder::~AtomicFolder() { remove_folder(temporary_); }

void AtomicFolder::commit() {
  for_each_file(temporary_, flush_to_disk);
  // After an exchange the temporary name holds the old content, which the destructor removes.
  if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) return;
  std::error_code error;
  if (errno != ENOENT) fs::remove_all(target_, error);  // file systems without exchange
  fs::rename(temporary_, target_, error);
  if (error) fail(target_, "cannot be put in place", error.value());
}

void AtomicFolder::join() {
  std::error_code error;
  if (!fs::exists(target_, error)) return commit();
  for_each_file(temporary_, flush_to_disk);
  for_each_file(temporary_, [this](const fs::path& file) {
    const fs::path place = target_ / file.lexically_relative(temporary_);
    std::error_code failed;
    fs::create_directories(place.parent_path(), failed);
    if (!failed) fs::rename(file, place, failed);
    if (failed) fail(place, "cannot be put in place", failed.value());
  });
}

}  // namespace rigsound
