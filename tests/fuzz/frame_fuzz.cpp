// Any frame through any layout onto the signal board: nothing is read past the end and no NaN gets through.
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "fuzz_target.hpp"
#include "rigsound/can/frame_decoder.hpp"
#include "rigsound/machine/state_resolver.hpp"

using namespace rigsound;

namespace {

/// Takes numbers off the front of the input; zeros when it is used up.
struct Bytes {
  const std::uint8_t* data;
  std::size_t size;
  template <class T>
  T take() {
    T value{};
    const std::size_t n = size < sizeof value ? size : sizeof value;
    std::memcpy(&value, data, n);
    data += n;
    size -= n;
    return value;
  }
};

can::BitField field(Bytes& bytes) {
  return {bytes.take<std::uint16_t>() % 14280, bytes.take<std::uint8_t>() % 64 + 1,
          static_cast<can::ByteOrder>(bytes.take<std::uint8_t>() % 2)};
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes{data, size};
  can::SignalRoute route;
  route.target = {static_cast<Signal>(bytes.take<std::uint8_t>() % kSignalCount), bytes.take<std::uint8_t>()};
  route.layout.field = field(bytes);
  route.layout.type = static_cast<can::ValueType>(bytes.take<std::uint8_t>() % 4);
  route.layout.scale = bytes.take<double>();
  route.layout.offset = bytes.take<double>();
  if (bytes.take<std::uint8_t>() % 2 == 1) route.layout.selectors.push_back({field(bytes), {{0, 3}}});
  route.match = {0x0CF00400, true, bytes.take<std::uint8_t>() % 2 == 1, {}};
  can::Frame frame;
  frame.id = route.match.id;
  frame.extended = true;
  frame.size = bytes.take<std::uint8_t>();
  for (std::uint8_t& byte : frame.data) byte = bytes.take<std::uint8_t>();

  std::vector<Reading> readings;
  can::FrameDecoder({route}).decode(frame, 0, readings);
  SignalBoard board;
  for (const Reading& reading : readings) board.take(reading);
  const MachineState state = StateResolver().resolve(board, {}, 0);
  const bool finite = std::isfinite(state.engine_rpm) && std::isfinite(state.engine_load) &&
                      std::isfinite(state.master_gain_db) && std::isfinite(state.boom[0].feed_pressure_bar) &&
                      std::isfinite(state.boom[0].percussion_rate_hz);
  if (!finite || state.engine_rpm < 0 || state.engine_rpm > 4000) std::abort();
  return 0;
}
