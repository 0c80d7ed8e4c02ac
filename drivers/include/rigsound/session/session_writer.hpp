// What a live run did, written so that a crash costs a second at most.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/audio/audio_options.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/machine/machine_state.hpp"

namespace rigsound::session {

constexpr int kSessionFormat = 5;        ///< 5: skips, and an end in order, are marked
constexpr int kOldestSessionFormat = 4;  ///< that is read too; 4: signals that a user holds are marked
constexpr double kLongestSkip_s = 3600;  ///< of a session; after a longer one the next begins

/// What must be the same for the same samples to come out.
struct SessionHeader {
  std::string program;      ///< version that wrote it
  std::string fingerprint;  ///< of engine options and sound set; hexadecimal
  std::string engine;       ///< kEngineSound of the engine that played; empty: of before it was written down
  std::uint64_t seed = 1;
  double sample_rate = 48000;  ///< Hz
  int block = 64;              ///< frames
  int channels = 2;
  audio::SampleFormat format = audio::SampleFormat::kFloat;  ///< the card's
  bool after_crash = false;  ///< begun soon after a session that a crash ended; SessionFolder says
};

/// A header in text, then chunks: kind, size and CRC-32, number of the block that follows, and the changes of
/// state since the chunk before (block, fields that changed), the blocks that were skipped, or the end. A
/// chunk that is not whole ends the file. Thread: CT.
class SessionWriter {
 public:
  /// `fd`: of the empty file that the session is written to; it stays locked (flock) until the end.
  /// Errors: DeviceError.
  SessionWriter(std::filesystem::path file, FileDescriptor fd, const SessionHeader& header);

  /// `state` acts from `block` on. Blocks must rise; the first is block 0.
  void add(std::uint64_t block, const MachineState& state);

  /// Hands everything to the kernel, which keeps it when this process is killed. `blocks`: rendered so
  /// far. Errors: DeviceError; the file then ends with the chunk before.
  void flush(std::uint64_t blocks);

  /// Before `block` time went by for `count` blocks that were not rendered. Errors as of flush().
  void skip(std::uint64_t block, std::uint64_t count);

  /// The run ends in order, after `blocks`. Errors as of flush().
  void end(std::uint64_t blocks);

  std::uint64_t bytes() const { return bytes_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  void append(const std::string& bytes);

  std::filesystem::path file_;
  FileDescriptor fd_;
  std::uint64_t bytes_ = 0;
  std::string changes_;  // of the chunk to come
  std::vector<std::uint32_t> last_words_;
  std::uint64_t last_block_ = 0;
};

}  // namespace rigsound::session
