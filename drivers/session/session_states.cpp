#include "rigsound/session/session_states.hpp"

namespace rigsound::session {

SessionStates::SessionStates(const std::filesystem::path& file) : file_(file, "session") {
  SessionChanges all(file_);
  for (Change change; all.next(change);) continue;
  blocks_ = all.blocks();
  skipped_ = all.skipped();
  ended_in_order_ = all.ended_in_order();
  ignored_ = all.bytes_ignored();
  rewind();
}

void SessionStates::rewind() {
  changes_.emplace(file_);
  acting_ = {};
  skipped_before_ = 0;
  more_ = changes_->next(ahead_);
}

void SessionStates::go_to(std::uint64_t number) {
  if (number < here_) rewind();
  here_ = number;
  while (more_ && ahead_.block <= number) {
    if (ahead_.block != acting_.block) skipped_before_ = acting_.skipped;
    acting_ = ahead_;
    more_ = changes_->next(ahead_);
  }
}

const MachineState* SessionStates::state_of(std::uint64_t number) {
  if (number >= blocks_) return nullptr;
  go_to(number);
  return &acting_.state;
}

std::uint64_t SessionStates::skipped_before(std::uint64_t number) {
  go_to(number);
  return acting_.block == number ? acting_.skipped - skipped_before_ : 0;
}

}  // namespace rigsound::session
