// A log that is text, read line by line.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "log/can_lines.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/log/can_reader.hpp"

namespace rigsound::log {

/// Thread: CT, one thread at a time.
class LineReader : public CanReader {
 public:
  /// Errors: InputError when the file cannot be opened.
  LineReader(const LogFile& file, std::unique_ptr<CanLineFormat> format);

  bool next(CanRecord& record) override;
  int line() const override { return line_; }
  double share() const override { return share_of(read_ - (end_ - begin_), bytes_); }
  std::string remark() const override { return format_->remark(); }

 private:
  bool read_line(std::string_view& line, bool& whole);
  bool read_more();
  void pass_over_line();
  void refuse_cut_line(std::string_view line, CanLine kind, const CanRecord& record) const;

  std::string file_;
  FileDescriptor fd_;
  std::uintmax_t bytes_, read_ = 0;  ///< of the file; with what is in the buffer
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  ///< of what is in the buffer and not yet read
  std::unique_ptr<CanLineFormat> format_;
  int line_ = 0;
  bool long_line_ = false;  ///< the rest of the last one is still to be passed over
  std::unordered_map<std::uint32_t, std::uint8_t> last_size_;  ///< by identifier
};

}  // namespace rigsound::log
