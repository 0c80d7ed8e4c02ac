// Any bytes as a log of one of the text formats: no crash, no frame longer than it may be. The first byte
// chooses the format, the rest are lines.
#include <cstdlib>
#include <string>

#include "fuzz_target.hpp"
#include "log/can_lines.hpp"
#include "rigsound/log/log_clock.hpp"

using namespace rigsound;

namespace {

std::unique_ptr<log::CanLineFormat> format_of(std::uint8_t choice) {
  switch (choice % 4) {
    case 0:
      return log::candump_format();
    case 1:
      return log::candump_format(log::CandumpStamps::kSinceLastFrame);
    case 2:
      return log::asc_format();
    default:
      return log::trc_format();
  }
}

void require_whole(const log::CanRecord& record) {
  const can::Frame& f = record.frame;
  if (f.size > (f.fd ? 64 : 8) || f.id > 0x1FFFFFFF || record.time_ns < 0) std::abort();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto format = format_of(data[0]);
  std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  log::LogClock clock(1.0);
  std::int64_t last_ns = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    log::CanRecord record;
    format->begins_a_frame(text.substr(0, end));
    if (format->parse(text.substr(0, end), record) == log::CanLine::kFrame) {
      require_whole(record);
      const std::int64_t now_ns = clock.place(record.time_ns, std::nullopt, 1);
      if (now_ns < last_ns) std::abort();
      last_ns = now_ns;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return 0;
}
