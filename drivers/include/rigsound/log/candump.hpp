// CAN logs as candump writes them and every tool of the field reads them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "rigsound/log/can_record.hpp"

namespace rigsound::log {

/// The line candump -l would write: upper case, six decimals, no direction, no newline.
std::string candump_line(const CanRecord& record);

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
