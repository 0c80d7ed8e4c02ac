// The changes of state that a session holds, one after the other.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/machine/machine_state.hpp"
#include "rigsound/session/session_writer.hpp"

namespace rigsound::session {

/// A session that ended before its first whole chunk.
class SessionWithoutState : public InputError {
 public:
  using InputError::InputError;
};

struct Chunk;

/// The state from `block` on, or time that was skipped before it.
struct Change {
  std::uint64_t block = 0;
  MachineState state;
  std::uint64_t skipped = 0;  ///< blocks before it that were not rendered, in all
};

/// Reads forward, a chunk at a time: what it needs does not grow with the session. Thread: OFF.
class SessionChanges {
 public:
  /// `file` must stay while this lives. Errors: InputError for a file that is no session or of another
  /// format.
  explicit SessionChanges(const InputFile& file);
  SessionChanges(const SessionChanges&) = delete;
  SessionChanges& operator=(const SessionChanges&) = delete;
  ~SessionChanges();

  const SessionHeader& header() const { return header_; }

  /// The next change, the first of block 0; false behind the last whole chunk. Errors: SessionWithoutState;
  /// InputError for what no writer writes: a value that its signal does not have, blocks that run backwards
  /// or on for more than an hour from one chunk to the next, a skip of more than an hour.
  bool next(Change& change);

  /// Of the chunks read so far; all of them once next() was false.
  std::uint64_t blocks() const { return blocks_; }    ///< rendered
  std::uint64_t skipped() const { return skipped_; }  ///< beside them
  bool ended_in_order() const;
  std::uint64_t bytes_ignored() const;  ///< behind the chunks read so far

 private:
  bool next_chunk();
  bool take_change();
  bool take_skip();
  Change change_of(std::uint64_t block) const;
  std::uint64_t longest_chunk() const;  // blocks
  void require_goes_on(const char* what, std::uint64_t block, std::uint64_t from, std::uint64_t to) const;
  [[noreturn]] void fail_without_state() const;

  std::string name_;
  std::filesystem::path path_;
  std::ifstream in_;
  SessionHeader header_;
  std::unique_ptr<Chunk> chunk_;
  std::string_view left_;  // of its payload
  std::vector<std::uint32_t> words_;
  std::uint64_t block_ = 0, told_ = 0;  // of the last change of state, and of the last change told
  std::uint64_t blocks_ = 0, skipped_ = 0;
  std::uint64_t end_ = 0;  // of the chunks, bytes from the start of the file
  bool begun_ = false;
};

}  // namespace rigsound::session
