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
    : ModbusBus(options.address, options.routes, listener, tap),
      options_(options),
      registers_(options.routes) {}

std::optional<Refusal> ModbusServer::carry_out(const Request& request, int unit, Exchange& change) const {
  const bool any_unit = options_.unit == kTcpUnit || unit == kTcpUnit || unit == kBroadcast;
  if (unit != options_.unit && !any_unit) return Refusal::kUnit;
  return registers_.check(request, change);
}

void ModbusServer::warn_refused(const Request& request, int function, Refusal refusal,
                                const std::string& peer) {
  std::string text = peer + ": function " + std::to_string(function) + " refused: " + reason(refusal);
  const std::optional<Range>& range = request.write ? request.write : request.read;
  if (range) text += ", " + describe(request.table, range->address);
  if (range && refusal == Refusal::kAddress) {
    const std::string meant = registers_.meant_address(request.table, *range);
    if (!meant.empty()) text += ": addresses count from 0, did you mean " + meant + "?";
  }
  warn(reason(refusal), text);
}

ModbusServer::Reply ModbusServer::respond(modbus_t* context, const std::uint8_t* adu, int size,
                                          std::size_t pdu_size, const std::string& peer) {
  const int header = modbus_get_header_length(context);
  const int unit = adu[header - 1];
  const bool no_answer = options_.transport != Transport::kTcp && unit == kBroadcast;
  Request request;
  Exchange change;
  std::optional<Refusal> refusal = parse(adu + header, pdu_size, request);
  if (!refusal) refusal = carry_out(request, unit, change);
  if (refusal) {
    warn_refused(request, adu[header], *refusal, peer);
    count_.refused.fetch_add(1, std::memory_order_relaxed);
    if (no_answer) return Reply::kNone;
    const int sent = modbus_reply_exception(context, adu, static_cast<unsigned>(*refusal));
    return sent < 0 ? Reply::kFailed : Reply::kSent;
  }
  change.unit = unit;
  // Before the answer leaves: who reads it may rely on the value being in force.
  if (!change.values.empty()) {
    ++writes_;
    report_exchange(change, options_.routes);
  }
  if (modbus_reply(context, adu, size, registers_.mapping()) < 0) return Reply::kFailed;
  count_.requests.fetch_add(1, std::memory_order_relaxed);
  return Reply::kSent;
}

}  // namespace rigsound::modbus
