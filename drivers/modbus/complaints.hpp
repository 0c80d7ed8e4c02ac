// Says what goes wrong at most once a second, and how much was left unsaid.
#pragma once

#include <cstdint>
#include <string>

#include "rigsound/modbus/modbus_link.hpp"

namespace rigsound::modbus {

class Complaints {
 public:
  explicit Complaints(ModbusListener& listener) : listener_(listener) {}
  void add(const std::string& text);

 private:
  ModbusListener& listener_;
  std::int64_t last_ms_ = -1000;
  std::uint64_t unsaid_ = 0;
};

}  // namespace rigsound::modbus
