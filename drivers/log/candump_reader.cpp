#include <array>
#include <limits>

#include "rigsound/log/candump.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

constexpr std::size_t kLongestLine = 8192;  // a CAN XL frame of 2048 bytes needs 4130

}  // namespace

CandumpReader::CandumpReader(const std::filesystem::path& file) : file_(file.string()) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw InputError(file_, "is a folder, expected a bus log");
  in_.open(file, std::ios::binary);
  if (!in_) throw InputError(file_, "cannot be opened, expected a readable bus log");
}

bool CandumpReader::read_line(std::string& line, bool& whole) {
  std::array<char, kLongestLine> buffer;
  in_.getline(buffer.data(), buffer.size());
  const std::streamsize got = in_.gcount();
  if (got == 0 && in_.eof()) return false;
  if (in_.bad()) throw InputError(file_, line_ + 1, {}, "cannot be read further");
  ++line_;
  whole = !in_.eof();
  const bool too_long = in_.fail() && !in_.eof();
  if (too_long) {
    in_.clear();
    in_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  const bool has_newline = whole && !too_long;
  line.assign(buffer.data(), has_newline ? got - 1 : got);
  return true;
}

void CandumpReader::refuse_cut_line(const std::string& line, CandumpLine kind,
                                    const CanRecord& record) const {
  const auto last = last_size_.find(record.frame.id);
  const bool shorter =
      kind == CandumpLine::kFrame && last != last_size_.end() && record.frame.size < last->second;
  const bool broken = kind == CandumpLine::kOther && line.front() == '(';
  if (shorter || broken)
    throw InputError(file_, line_, {}, "the log ends in the middle of a frame, expected a whole last line");
}

void CandumpReader::count(const CanRecord& record) {
  if (counts_.frames++ > 0 && record.time_ns < last_ns_ && counts_.backwards++ == 0)
    counts_.first_backwards_line = line_;
  last_ns_ = record.time_ns;
  if (record.frame.error) ++counts_.error_frames;
  last_size_[record.frame.id] = record.frame.size;
}

bool CandumpReader::next(CanRecord& record) {
  std::string line;
  bool whole = true;
  while (read_line(line, whole)) {
    const CandumpLine kind = parse_candump_line(line, record);
    if (!whole && !line.empty()) refuse_cut_line(line, kind, record);
    if (kind == CandumpLine::kFrame) {
      count(record);
      return true;
    }
    ++(kind == CandumpLine::kXl ? counts_.xl : counts_.other);
  }
  return false;
}

}  // namespace rigsound::log
