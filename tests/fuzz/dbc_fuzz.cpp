// Any bytes as a DBC file: read or refused with a message, and whatever layout comes out reads no frame past
// its end.
#include "fuzz_target.hpp"
#include "rigsound/can/signal_reading.hpp"
#include "rigsound/config/dbc.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  can::Frame frame;
  frame.size = 8;
  try {
    const config::Dbc dbc = config::parse_dbc({reinterpret_cast<const char*>(data), size}, "fuzz.dbc");
    for (const config::DbcMessage& message : dbc.messages)
      for (const config::DbcSignal& signal : message.signals)
        if (signal.layout.field.length <= 64)
          can::read_signal(signal.layout, message.j1939 ? can::RawValues::kJ1939 : can::RawValues::kAll,
                           frame);
  } catch (const InputError&) {
  }
  return 0;
}
