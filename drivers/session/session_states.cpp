#include "rigsound/session/session_states.hpp"

namespace rigsound::session {

SessionStates::SessionStates(const std::filesystem::path& file) : file_(file, "session") {
  SessionChanges all(file_);
  for (Change change; all.next(change);) continue;
  blocks_ = all.blocks();
  ignored_ = all.bytes_ignored();
  rewind();
}

void SessionStates::rewind() {
  changes_.emplace(file_);
  more_ = changes_->next(ahead_);
}

const MachineState* SessionStates::state_of(std::uint64_t number) {
  if (number >= blocks_) return nullptr;
  if (number < acting_.block) rewind();
  while (more_ && ahead_.block <= number) {
    acting_ = ahead_;
    more_ = changes_->next(ahead_);
  }
  return &acting_.state;
}

}  // namespace rigsound::session
