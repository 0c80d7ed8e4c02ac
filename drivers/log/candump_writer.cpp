#include "rigsound/log/candump.hpp"

#include <algorithm>
#include <cstdio>

#include "log/frame_text.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::log {

std::string candump_line(const CanRecord& record) {
  const can::Frame& f = record.frame;
  char text[64];
  std::snprintf(text, sizeof text, "(%010lld.%06lld) ", static_cast<long long>(record.time_ns / 1000000000),
                static_cast<long long>(record.time_ns / 1000 % 1000000));
  std::string line = text + record.interface;
  const bool long_id = f.extended || f.error;
  std::snprintf(text, sizeof text, long_id ? " %08X#" : " %03X#", f.error ? f.id | kErrorFlag : f.id);
  line += text;
  if (f.remote) {
    line += 'R';
    if (f.size > 0) line += static_cast<char>('0' + std::min<int>(f.size, 8));
  } else if (f.fd) {
    std::snprintf(text, sizeof text, "#%X", 4U | (f.bit_rate_switch ? 1U : 0U) | (f.error_passive ? 2U : 0U));
    line += text;
  }
  for (int i = 0; !f.remote && i < std::min<int>(f.size, can::kMaxData); ++i) {
    std::snprintf(text, sizeof text, "%02X", f.data[i]);
    line += text;
  }
  if (f.raw_dlc > 8 && !f.fd && f.size == 8) {
    std::snprintf(text, sizeof text, "_%X", f.raw_dlc & 0xFU);
    line += text;
  }
  return line;
}

CandumpWriter::CandumpWriter(const std::filesystem::path& file) : file_(file), out_(file, std::ios::trunc) {
  flush();
}

void CandumpWriter::write(const CanRecord& record) { out_ << candump_line(record) << '\n'; }

void CandumpWriter::flush() {
  out_.flush();
  if (!out_) throw DeviceError(file_.string() + ": cannot be written");
}

}  // namespace rigsound::log
