// The registers a server holds for its rig, and the rule about who may change them to what.
#pragma once

#include <modbus.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modbus/request.hpp"
#include "rigsound/modbus/exchange.hpp"

namespace rigsound::modbus {

/// Readable: from the first to the last address in use of each table (gaps read 0). Writable: ranges with at
/// least one address in use, whole values only, such that the signal takes (SignalInfo::takes). Values start
/// at 0.
class RegisterFile {
 public:
  explicit RegisterFile(const std::vector<RegisterRoute>& routes);

  /// Whether the request may pass; then `change` holds what it writes (no values: it writes nothing).
  std::optional<Refusal> check(const Request& request, Exchange& change) const;

  /// `holding 0 = 40001` for a writer that sent the manual's number 40001 as an address; else empty.
  std::string meant_address(Table table, const Range& range) const;

  /// For modbus_reply, which carries out what check() let pass.
  modbus_mapping_t* mapping() { return mapping_.get(); }

 private:
  struct Free {
    void operator()(modbus_mapping_t* m) const { modbus_mapping_free(m); }
  };
  bool readable(Table table, const Range& range) const;
  bool writable(Table table, const Range& range) const;
  std::uint16_t held(std::uint16_t address) const;
  std::optional<Refusal> check_values(const Exchange& change) const;

  std::vector<RegisterRoute> routes_;
  std::array<Range, 4> span_{};  // by Table
  std::unique_ptr<modbus_mapping_t, Free> mapping_;
};

}  // namespace rigsound::modbus
