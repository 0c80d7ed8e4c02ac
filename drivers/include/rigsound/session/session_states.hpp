// A session as a source of states: the run, once more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "rigsound/audio/block_loop.hpp"
#include "rigsound/session/session_changes.hpp"

namespace rigsound::session {

/// Reads the session once to check it, and then as the blocks go on. Thread: OFF.
class SessionStates : public audio::StateSource {
 public:
  /// Errors: as SessionChanges; none comes later.
  explicit SessionStates(const std::filesystem::path& file);

  const SessionHeader& header() const { return changes_->header(); }
  std::uint64_t blocks() const { return blocks_; }          ///< of the whole chunks
  std::uint64_t bytes_ignored() const { return ignored_; }  ///< after them: a torn or damaged end

  SessionChanges changes() const { return SessionChanges(file_); }  ///< all of them, from the first one on

  const MachineState* state_of(std::uint64_t number) override;

 private:
  void rewind();

  InputFile file_;
  std::optional<SessionChanges> changes_;
  std::uint64_t blocks_ = 0, ignored_ = 0;
  Change acting_, ahead_;
  bool more_ = false;  // ahead_ is yet to act
};

}  // namespace rigsound::session
