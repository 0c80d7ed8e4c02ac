// Asks the units of one line for every register of the rig, each once a poll, in turn.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "modbus/client_link.hpp"
#include "modbus/modbus_bus.hpp"
#include "modbus/poll_plan.hpp"

namespace rigsound::modbus {

/// Devices as they are: some close after each answer (the connection is made again at once, and the request
/// repeated), some have holes in their tables (a request that is refused is split, and stays split). A pause
/// comes only after a contact without a single answer, and a unit's signals are down only when it was silent
/// for `down_after_s`.
class Client final : public ModbusBus {
 public:
  Client(const Line& line, BusListener& listener, ModbusTap* tap);
  void step() override;

 private:
  struct Unit {
    explicit Unit(const ModbusOptions& its) : options(its), plan(poll_plan(its.routes)) {}
    ModbusOptions options;
    std::vector<PollRequest> plan;
    std::int64_t next_poll_ms = 0;
    Backoff pause;          ///< after polls without an answer, when others share the line
    double answered_s = 0;  ///< last
    bool delivers = false;
  };
  enum class Outcome : std::uint8_t { kAnswered, kRefused, kSilent, kLost };

  std::size_t next_unit(std::int64_t now_ms) const;
  bool wait_until(std::int64_t due_ms) const;
  bool connect();
  void poll(Unit& unit);
  Outcome ask(Unit& unit, const PollRequest& request);
  Outcome after_error(Unit& unit, int error);
  void take(Unit& unit, const Exchange& answer);
  void refused(Unit& unit, const PollRequest& request, int error);
  void drop(int error);
  void tell_silence();
  std::string of_unit(const Unit& unit, const std::string& what) const;

  std::vector<Unit> units_;
  std::size_t last_ = 0;  // unit that was asked last
  std::unique_ptr<ClientLink> link_;
  bool answered_ = false;  // since the connection was made
  bool up_ = false;
  std::int64_t next_request_ms_ = 0;
  std::string last_problem_;
};

}  // namespace rigsound::modbus
