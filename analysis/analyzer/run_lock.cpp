#include "analyzer/run_lock.hpp"

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

}  // namespace

MadeFolder::MadeFolder(const fs::path& folder)
    : folder_(folder), unfinished_([this] {
        std::error_code error;
        made_ = fs::create_directories(folder_, error);
        if (error) throw DeviceError(folder_.string() + ": cannot be made: " + error.message());
        return [this] { remove_if_empty(); };
      }) {}
MadeFolder::~MadeFolder() { remove_if_empty(); }

void MadeFolder::remove_if_empty() const {
  std::error_code error;  // of a folder that is not empty
  if (!made_) return;
  fs::remove(folder_ / "banks", error);
  fs::remove(folder_, error);
}

RunLock::RunLock(const fs::path& sound_set) : folder_(sound_set), lock_(sound_set / ".run.lock") {
  if (lock_.try_exclusive()) remove_unfinished(sound_set / "banks");
  lock_.wait_shared();
}

}  // namespace rigsound::analysis
