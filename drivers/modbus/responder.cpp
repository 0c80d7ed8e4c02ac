#include "modbus/responder.hpp"
#include "rigsound/monotonic_time.hpp"

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

Responder::Responder(const ModbusOptions& options, ModbusListener& listener, Complaints& complaints)
    : options_(options), listener_(listener), complaints_(complaints), registers_(options.routes) {}

Responder::Outcome Responder::respond(modbus_t* context, const std::uint8_t* adu, int size,
                                      std::size_t pdu_size, const std::string& peer) {
  const int header = modbus_get_header_length(context);
  const int unit = adu[header - 1];
  Request request;
  Exchange change;
  std::optional<Refusal> refusal = parse(adu + header, pdu_size, request);
  if (!refusal) refusal = registers_.judge(request, change);
  if (unit != options_.unit && options_.unit != kTcpUnit && unit != kTcpUnit && unit != kBroadcast)
    refusal = Refusal::kUnit;
  if (refusal) {
    complaints_.add("modbus " + options_.address + ": " + peer + ": function " + std::to_string(adu[header]) +
                    " refused: " + reason(*refusal) +
                    (request.write ? ", " + describe(request.table, request.write->address) : ""));
    const int sent = modbus_reply_exception(context, adu, static_cast<unsigned>(*refusal));
    return sent < 0 ? Outcome::kNotSent : Outcome::kRefused;
  }
  change.unit = unit;
  if (!change.values.empty()) tell(change);
  return modbus_reply(context, adu, size, registers_.mapping()) < 0 ? Outcome::kNotSent : Outcome::kAnswered;
}

// Before the answer leaves: who reads it may rely on the value being in force.
void Responder::tell(const Exchange& change) {
  listener_.exchange(change);
  std::vector<Reading> values;
  readings(change, options_.routes, monotonic_s(), values);
  listener_.readings(values);
}

}  // namespace rigsound::modbus
