#include "modbus/modbus_server.hpp"

namespace rigsound::modbus {
namespace {

constexpr int kBroadcast = 0, kTcpUnit = 255;

const char* reason(Refusal refusal) {
  switch (refusal) {
    case Refusal::kFunction:
      return "unknown function";
    case Refusal::kAddress:
      return "address not in the rig";
    case Refusal::kValue:
      return "value out of range, not whole, or not of its length";
    case Refusal::kUnit:
      return "another unit's request";
  }
  return "";
}

}  // namespace

ModbusServer::ModbusServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap)
    : ModbusBus(options, listener, tap), registers_(options.routes) {}

bool ModbusServer::respond(modbus_t* context, const std::uint8_t* adu, int size, std::size_t pdu_size,
                           const std::string& peer) {
  const int header = modbus_get_header_length(context);
  const int unit = adu[header - 1];
  Request request;
  Exchange change;
  std::optional<Refusal> refusal = parse(adu + header, pdu_size, request);
  if (!refusal) refusal = registers_.check(request, change);
  if (unit != options_.unit && options_.unit != kTcpUnit && unit != kTcpUnit && unit != kBroadcast)
    refusal = Refusal::kUnit;
  if (refusal) {
    warn(text(peer + ": function " + std::to_string(adu[header]) + " refused: " + reason(*refusal) +
              (request.write ? ", " + describe(request.table, request.write->address) : "")));
    if (modbus_reply_exception(context, adu, static_cast<unsigned>(*refusal)) < 0) return false;
    count_.refused.fetch_add(1, std::memory_order_relaxed);
    return true;
  }
  change.unit = unit;
  // Before the answer leaves: who reads it may rely on the value being in force.
  if (!change.values.empty()) report_exchange(change);
  if (modbus_reply(context, adu, size, registers_.mapping()) < 0) return false;
  count_.requests.fetch_add(1, std::memory_order_relaxed);
  return true;
}

}  // namespace rigsound::modbus
