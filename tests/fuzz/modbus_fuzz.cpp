// Any bytes as a Modbus request: no crash, and what is let pass writes whole values in their range.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "modbus/register_file.hpp"

using namespace rigsound;
using namespace rigsound::modbus;

namespace {

RegisterRoute route(Signal signal, Table table, std::uint16_t address, WordType type) {
  RegisterRoute r;
  r.target = {signal, 0};
  r.table = table;
  r.address = address;
  r.type = type;
  r.order = WordOrder::kCdab;
  return r;
}

const std::vector<RegisterRoute>& routes() {
  static const std::vector<RegisterRoute> all = {
      route(Signal::kRodCount, Table::kHolding, 0, WordType::kUint16),
      route(Signal::kEngineRpm, Table::kHolding, 2, WordType::kFloat32),
      route(Signal::kMasterGainDb, Table::kHolding, 65535, WordType::kInt16),
      route(Signal::kPercussion, Table::kCoil, 7, WordType::kUint16),
      route(Signal::kFeedPressureBar, Table::kInput, 3, WordType::kUint32)};
  return all;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const RegisterFile registers(routes());
  Request request;
  Exchange change;
  if (parse(data, size, request) || registers.check(request, change)) return 0;
  const std::size_t wanted = request.write ? static_cast<std::size_t>(request.write->count) : 0;
  if (change.values.size() != wanted) std::abort();
  std::vector<Reading> written;
  readings(change, routes(), 0, written);
  for (const Reading& r : written)
    if (!info(r.id.signal).takes(r.value)) std::abort();
  return 0;
}
