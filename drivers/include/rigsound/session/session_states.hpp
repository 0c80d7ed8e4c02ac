// A session as a source of states: the run, once more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/audio/block_loop.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/session/session_writer.hpp"

namespace rigsound::session {

/// A session that ended before its first whole chunk.
class SessionWithoutState : public InputError {
 public:
  using InputError::InputError;
};

/// Thread: OFF.
class SessionStates : public audio::StateSource {
 public:
  /// Errors: InputError for a file that is no session or of another format, SessionWithoutState.
  explicit SessionStates(const std::filesystem::path& file);

  const SessionHeader& header() const { return header_; }
  std::uint64_t blocks() const { return blocks_; }  ///< rendered, of the whole chunks
  std::uint64_t skipped() const;                    ///< beside them
  bool ended_in_order() const { return ended_in_order_; }
  std::uint64_t bytes_ignored() const { return ignored_; }  ///< after them: a torn or damaged end

  /// From `block` on.
  struct Change {
    std::uint64_t block = 0;
    MachineState state;
    std::uint64_t skipped = 0;  ///< blocks before it, in all
  };
  const std::vector<Change>& changes() const { return changes_; }  ///< in order, the first of block 0

  const MachineState* state_of(std::uint64_t number) override;
  std::uint64_t skipped_before(std::uint64_t number) override;

 private:
  void read_chunks(const std::string& file, const std::string& bytes, std::size_t at);
  void take_skip(const std::string& file, std::uint64_t block, std::string_view payload);

  SessionHeader header_;
  std::vector<Change> changes_;
  std::map<std::uint64_t, std::uint64_t> skips_;  // blocks skipped, by the block they come before
  std::uint64_t blocks_ = 0, ignored_ = 0;
  bool ended_in_order_ = false;
  std::size_t next_ = 0;  // change not yet acting
};

}  // namespace rigsound::session
