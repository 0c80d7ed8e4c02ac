// Formats of CAN logs that are text: one line, one frame.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "rigsound/log/can_record.hpp"

namespace rigsound::log {

enum class CanLine : std::uint8_t {
  kFrame,
  kXl,     ///< a CAN XL frame: known, not used
  kOther,  ///< a comment, a blank line, a line of something else
};

/// Reads the lines of one file in their order. Thread: one at a time.
class CanLineFormat {
 public:
  virtual ~CanLineFormat() = default;

  /// A line without its newline (a carriage return at the end is ignored). `record` is written only for
  /// kFrame.
  virtual CanLine parse(std::string_view line, CanRecord& record) = 0;

  /// Whether a line that is no frame begins as one: the last line of a file, cut off.
  virtual bool begins_a_frame(std::string_view line) const = 0;

  virtual std::string remark() const { return {}; }
};

/// How the stamps of a candump screen count (its option -t).
enum class CandumpStamps : std::uint8_t { kAbsolute, kSinceLastFrame };

/// candump -l, and what candump shows on the screen with any of its options -t -x -i -S -a -H -8 -c. 1 to 9
/// decimals. Lines without a stamp are a millisecond apart.
std::unique_ptr<CanLineFormat> candump_format(CandumpStamps stamps = CandumpStamps::kAbsolute);

/// Vector ASC: CAN and CAN FD lines, hexadecimal or decimal, absolute or relative stamps. Channel 1 is
/// `can0`.
std::unique_ptr<CanLineFormat> asc_format();

/// PEAK TRC 1.0 to 2.1. Bus 1 is `can0`.
std::unique_ptr<CanLineFormat> trc_format();

}  // namespace rigsound::log
