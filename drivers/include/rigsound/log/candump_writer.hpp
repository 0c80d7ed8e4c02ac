// Writes what a CAN bus carries, as candump -l does.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "rigsound/log/candump.hpp"

namespace rigsound::log {

/// Lines are handed to the kernel on flush(). Thread: one at a time. Errors: DeviceError.
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
