// Any bytes as a datagram: no crash, and readings only of signals that the input has.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "rigsound/machine/signal_board.hpp"
#include "rigsound/udp/datagram_reader.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const udp::DatagramReader reader(
      {{{Signal::kEngineRpm, 0}, "engine_rpm", ""}, {{Signal::kRattling, 1}, "boom2.rattling", ""}});
  std::string problem;
  const auto content = reader.read({reinterpret_cast<const char*>(data), size}, 1, problem);
  if (!content) {
    if (problem.empty()) std::abort();
    return 0;
  }
  SignalBoard board;
  for (const Reading& reading : content->readings) {
    if (reading.id.signal != Signal::kEngineRpm && reading.id.signal != Signal::kRattling) std::abort();
    if (board.take(reading) == Validity::kValid &&
        !info(reading.id.signal).takes(board.entry(reading.id).value))
      std::abort();
  }
  return 0;
}
