#include "rigsound/log/candump.hpp"

#include "rigsound/device_error.hpp"

namespace rigsound::log {

CandumpWriter::CandumpWriter(const std::filesystem::path& file) : file_(file), out_(file, std::ios::trunc) {
  flush();
}

void CandumpWriter::write(const CanRecord& record) { out_ << candump_line(record) << '\n'; }

void CandumpWriter::flush() {
  out_.flush();
  if (!out_) throw DeviceError(file_.string() + ": cannot be written");
}

}  // namespace rigsound::log
