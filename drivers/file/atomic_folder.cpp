#include "rigsound/file/atomic_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <vector>

#include "file/flush.hpp"
#include "rigsound/file/make_folders.hpp"

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

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

void flush_all(const std::vector<fs::path>& files, const Progress& progress = {}) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    flush_to_disk(files[i]);
    show(progress, i + 1, files.size());
  }
}

}  // namespace

AtomicFolder::AtomicFolder(const fs::path& target)
    : target_(file::behind_links(target.has_filename() ? target : target.parent_path())) {
  const fs::path parent = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  make_folders(parent);
  std::string name = (parent / ("." + target_.filename().string() + ".XXXXXX")).string();
  unfinished_ = std::make_unique<Unfinished>([&] {
    if (::mkdtemp(name.data()) == nullptr) fail(target_, "cannot be written", errno);
    ::chmod(name.c_str(), 0755);
    temporary_ = name;
    return [folder = temporary_] { remove_folder(folder); };
  });
}

AtomicFolder::~AtomicFolder() { remove_folder(temporary_); }

void AtomicFolder::commit(const Progress& progress) {
  flush_all(files_in(temporary_), progress);
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
  const std::vector<fs::path> files = files_in(temporary_);
  flush_all(files);
  for (const fs::path& file : files) {
    const fs::path place = target_ / file.lexically_relative(temporary_);
    make_folders(place.parent_path());
    std::error_code failed;
    fs::rename(file, place, failed);
    if (failed) fail(place, "cannot be put in place", failed.value());
  }
}

}  // namespace rigsound
