// Any bytes as an OSC packet: no crash, and whatever is read has an address and can be looked up.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "rigsound/osc/address_space.hpp"
#include "rigsound/osc/packet.hpp"

using namespace rigsound;

namespace {

osc::OscOptions two_booms() {
  osc::OscOptions options;
  options.routes = {{{Signal::kEngineRpm, 0}, "engine_rpm", ""},
                    {{Signal::kRattling, 1}, "boom2.rattling", ""}};
  options.booms = {"boom1", "boom2"};
  return options;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const osc::AddressSpace addresses(two_booms());
  std::string problem;
  const auto messages = osc::read_packet({reinterpret_cast<const char*>(data), size}, problem);
  if (!messages) {
    if (problem.empty()) std::abort();
    return 0;
  }
  for (const osc::Message& message : *messages) {
    if (message.path.empty() || message.path.front() != '/') std::abort();
    addresses.find(message.path);
  }
  return 0;
}
