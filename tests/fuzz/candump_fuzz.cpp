// Any bytes as a line of a CAN log: no crash, and what is a frame survives being written and read again.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "rigsound/log/candump.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  log::CanRecord first, second;
  if (log::parse_candump_line(line, first) != log::CandumpLine::kFrame) return 0;
  const std::string written = log::candump_line(first);
  if (log::parse_candump_line(written, second) != log::CandumpLine::kFrame) std::abort();
  if (second.frame.id != first.frame.id || second.frame.size != first.frame.size ||
      second.frame.data != first.frame.data || second.interface != first.interface)
    std::abort();
  if (log::candump_line(second) != written) std::abort();
  return 0;
}
