#include "analyzer/run_lock.hpp"

#include <iterator>

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

constexpr const char* kRunLock = ".run.lock";

/// Banks are filled under a name with a leading dot and renamed when they are whole.
void remove_unfinished(const fs::path& banks) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(banks, error))
    if (entry.path().filename().string()[0] == '.') fs::remove_all(entry.path(), error);
}

}  // namespace

RunLock::RunLock(const fs::path& sound_set) : sound_set_(sound_set), lock_(sound_set / kRunLock) {
  if (lock_.try_exclusive()) remove_unfinished(sound_set / "banks");
  lock_.wait_shared();
}

void RunLock::remove_if_alone() {
  std::error_code error;
  const fs::directory_iterator inside(sound_set_, error);
  if (std::distance(begin(inside), end(inside)) != 1 || !lock_.try_exclusive()) return;
  fs::remove(sound_set_ / kRunLock, error);
  fs::remove(sound_set_, error);
}

}  // namespace rigsound::analysis
