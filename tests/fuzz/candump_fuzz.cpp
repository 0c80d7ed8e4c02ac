// Any bytes as a line of a CAN log: no crash, and what is a frame survives being written and read again.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "log/can_lines.hpp"
#include "rigsound/log/candump.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  log::CanRecord first, second;
  if (log::candump_format()->parse(line, first) != log::CanLine::kFrame) return 0;
  const std::string written = log::candump_line(first);
  if (log::candump_format()->parse(written, second) != log::CanLine::kFrame) std::abort();
  if (second.frame.id != first.frame.id || second.frame.size != first.frame.size ||
      second.frame.data != first.frame.data || second.interface != first.interface)
    std::abort();
  if (log::candump_line(second) != written) std::abort();
  return 0;
}
