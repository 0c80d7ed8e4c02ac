#include "log/line_reader.hpp"

#include <array>
#include <limits>

#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

constexpr std::size_t kLongestLine = 8192;  // a CAN XL frame of 2048 bytes needs 4130

}  // namespace

LineReader::LineReader(const LogFile& file, std::unique_ptr<CanLineFormat> format)
    : file_(file.name()), in_(file.path(), std::ios::binary), format_(std::move(format)) {
  if (!in_) throw InputError(file_, "cannot be opened, expected a readable bus log");
}

bool LineReader::read_line(std::string& line, bool& whole) {
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

void LineReader::refuse_cut_line(const std::string& line, CanLine kind, const CanRecord& record) const {
  const auto last = last_size_.find(record.frame.id);
  const bool shorter =
      kind == CanLine::kFrame && last != last_size_.end() && record.frame.size < last->second;
  const bool broken = kind == CanLine::kOther && format_->begins_a_frame(line);
  if (shorter || broken)
    throw InputError(file_, line_, {}, "the log ends in the middle of a frame, expected a whole last line");
}

bool LineReader::next(CanRecord& record) {
  std::string line;
  bool whole = true;
  while (read_line(line, whole)) {
    const CanLine kind = format_->parse(line, record);
    if (!whole && !line.empty()) refuse_cut_line(line, kind, record);
    if (kind != CanLine::kFrame) {
      ++(kind == CanLine::kXl ? counts_.xl : counts_.other);
      continue;
    }
    ++counts_.frames;
    if (record.frame.error) ++counts_.error_frames;
    last_size_[record.frame.id] = record.frame.size;
    return true;
  }
  return false;
}

}  // namespace rigsound::log
