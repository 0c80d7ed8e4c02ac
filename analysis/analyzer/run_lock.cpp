#include "analyzer/run_lock.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

/// Banks are filled under a name with a leading dot and renamed when they are whole.
void remove_unfinished(const fs::path& banks) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(banks, error))
    if (entry.path().filename().string()[0] == '.') fs::remove_all(entry.path(), error);
}

}  // namespace

RunLock::RunLock(const fs::path& sound_set) : lock_(sound_set / ".run.lock") {
  if (lock_.try_exclusive()) remove_unfinished(sound_set / "banks");
  lock_.wait_shared();
}

}  // namespace rigsound::analysis
