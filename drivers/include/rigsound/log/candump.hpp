// CAN logs as `candump -l` writes them and every tool of the field reads them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

#include "rigsound/can/frame.hpp"

namespace rigsound::log {

/// One line: a frame, when and where it was seen.
struct CanRecord {
  std::int64_t time_ns = 0;  ///< since the epoch, or whatever the recorder counted from
  std::string interface;
  can::Frame frame;
};

enum class CandumpLine : std::uint8_t {
  kFrame,
  kXl,     ///< a CAN XL frame: known, not used
  kOther,  ///< a comment, a blank line, a line of something else
};

/// Reads one line without its newline (a carriage return at the end is ignored). `record` is written
/// only for kFrame. Thread: any.
CandumpLine parse_candump_line(std::string_view line, CanRecord& record);

/// The line candump would write: upper case, six decimals, no direction, no newline.
std::string candump_line(const CanRecord& record);

struct CandumpCounts {
  std::uint64_t frames = 0;
  std::uint64_t error_frames = 0;  ///< of those
  std::uint64_t xl = 0;            ///< lines skipped: CAN XL
  std::uint64_t other = 0;         ///< lines skipped: not a frame
  std::uint64_t backwards = 0;     ///< frames older than the one before
  int first_backwards_line = 0;
};

/// Streams a log in the order of the file. Thread: CT, one thread at a time.
class CandumpReader {
 public:
  /// Errors: InputError when the file cannot be opened.
  explicit CandumpReader(const std::filesystem::path& file);

  /// The next frame, or false at the end. Errors: InputError with the line when the file was cut off: its
  /// last line has no newline and is no whole frame, or a shorter one than the last of that identifier.
  bool next(CanRecord& record);

  const CandumpCounts& counts() const { return counts_; }
  int line() const { return line_; }

 private:
  bool read_line(std::string& line, bool& whole);
  void refuse_cut_line(const std::string& line, CandumpLine kind, const CanRecord& record) const;
  void count(const CanRecord& record);

  std::string file_;
  std::ifstream in_;
  CandumpCounts counts_;
  int line_ = 0;
  std::int64_t last_ns_ = 0;
  std::map<std::uint32_t, std::uint8_t> last_size_;  ///< by identifier
};

/// Writes what a CAN bus carries, as candump -l does. Lines are handed to the kernel on flush(). Thread: one
/// at a time. Errors: DeviceError.
class CandumpWriter {
 public:
  explicit CandumpWriter(const std::filesystem::path& file);

  void write(const CanRecord& record);
  void flush();

 private:
  std::filesystem::path file_;
  std::ofstream out_;
};

}  // namespace rigsound::log
