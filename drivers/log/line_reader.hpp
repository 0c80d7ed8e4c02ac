// A log that is text, read line by line.
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <string>

#include "log/can_lines.hpp"
#include "rigsound/log/can_reader.hpp"

namespace rigsound::log {

/// Thread: CT, one thread at a time.
class LineReader : public CanReader {
 public:
  /// Errors: InputError when the file cannot be opened.
  LineReader(const LogFile& file, std::unique_ptr<CanLineFormat> format);

  bool next(CanRecord& record) override;
  int line() const override { return line_; }
  std::string remark() const override { return format_->remark(); }

 private:
  bool read_line(std::string& line, bool& whole);
  void refuse_cut_line(const std::string& line, CanLine kind, const CanRecord& record) const;

  std::string file_;
  std::ifstream in_;
  std::unique_ptr<CanLineFormat> format_;
  int line_ = 0;
  std::map<std::uint32_t, std::uint8_t> last_size_;  ///< by identifier
};

}  // namespace rigsound::log
