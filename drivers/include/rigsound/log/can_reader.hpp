// The CAN frames of a log, whatever tool wrote it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/log/can_record.hpp"
#include "rigsound/log/log_file.hpp"

namespace rigsound::log {

struct CanCounts {
  std::uint64_t frames = 0;
  std::uint64_t error_frames = 0;  ///< of those
  std::uint64_t xl = 0;            ///< skipped: CAN XL
  std::uint64_t other = 0;         ///< skipped: lines, or packets, that are no frame
};

/// Thread: CT, one thread at a time.
class CanReader {
 public:
  virtual ~CanReader() = default;

  /// The next frame in the order of the file, or false at the end. Errors: InputError for a file that was cut
  /// off: its last line has no newline and is no whole frame, or a shorter one than the last of that
  /// identifier.
  virtual bool next(CanRecord& record) = 0;

  virtual int line() const = 0;      ///< of the last frame; 0: the file has no lines
  virtual double share() const = 0;  ///< of the file that has been read, 0...1
  virtual std::string remark() const {
    return {};
  }  ///< what a user should know of the stamps; empty: nothing
  const CanCounts& counts() const { return counts_; }

 protected:
  CanCounts counts_;
};

/// A candump log or screen, an ASC, a TRC, a capture of SocketCAN. Errors: InputError for a file of another
/// format, with its name and what converts it, and for a capture without CAN.
std::unique_ptr<CanReader> open_can_reader(const LogFile& file);

/// What a log is, as far as its beginning tells.
enum class LogFormat : std::uint8_t { kCandump, kAsc, kTrc, kCapture };

/// Errors: InputError for a format that is not read.
LogFormat format_of(const LogFile& file);

}  // namespace rigsound::log
