#include "log/line_reader.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

constexpr std::size_t kLongestLine = 8192;  // a CAN XL frame of 2048 bytes needs 4130
constexpr std::size_t kBuffer = 1 << 17;

}  // namespace

LineReader::LineReader(const LogFile& file, std::unique_ptr<CanLineFormat> format)
    : file_(file.name()),
      fd_(::open(file.path().c_str(), O_RDONLY | O_CLOEXEC)),
      bytes_(file.bytes()),
      buffer_(kBuffer),
      format_(std::move(format)) {
  if (!fd_) throw InputError(file_, "cannot be opened, expected a readable bus log");
}

/// False at the end of the file.
bool LineReader::read_more() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  ssize_t got = 0;
  do got = ::read(fd_.get(), buffer_.data() + end_, buffer_.size() - end_);
  while (got < 0 && errno == EINTR);
  if (got < 0) throw InputError(file_, line_ + 1, {}, "cannot be read further");
  end_ += static_cast<std::size_t>(got);
  read_ += static_cast<std::uintmax_t>(got);
  return got > 0;
}

void LineReader::pass_over_line() {
  do {
    const void* const newline = std::memchr(buffer_.data() + begin_, '\n', end_ - begin_);
    begin_ = newline != nullptr ? static_cast<const char*>(newline) - buffer_.data() + 1 : end_;
    if (newline != nullptr) return;
  } while (read_more());
}

/// Of a line longer than any frame its start. `line` stays until the next call.
bool LineReader::read_line(std::string_view& line, bool& whole) {
  if (long_line_) pass_over_line();
  std::size_t size = 0;  // without a newline so far
  const void* newline = nullptr;
  do {
    const char* const start = buffer_.data() + begin_;
    newline = std::memchr(start + size, '\n', end_ - begin_ - size);
    size = newline != nullptr ? static_cast<const char*>(newline) - start : end_ - begin_;
  } while (newline == nullptr && size < kLongestLine && read_more());
  if (size == 0 && newline == nullptr) return false;
  ++line_;
  long_line_ = size >= kLongestLine;
  whole = newline != nullptr || long_line_;
  line = {buffer_.data() + begin_, std::min(size, kLongestLine)};
  if (!long_line_) begin_ += size + (newline != nullptr ? 1 : 0);
  return true;
}

void LineReader::refuse_cut_line(std::string_view line, CanLine kind, const CanRecord& record) const {
  const auto last = last_size_.find(record.frame.id);
  const bool shorter =
      kind == CanLine::kFrame && last != last_size_.end() && record.frame.size < last->second;
  const bool broken = kind == CanLine::kOther && format_->begins_a_frame(line);
  if (shorter || broken)
    throw InputError(file_, line_, {}, "the log ends in the middle of a frame, expected a whole last line");
}

bool LineReader::next(CanRecord& record) {
  std::string_view line;
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
