// Requests and answers as the examples of the Modbus application protocol, V1.1b3, section 6, have them.
#include "modbus/pdu.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace rigsound::modbus;

namespace {

using Octets = std::vector<std::uint8_t>;

const std::vector<std::uint16_t> kTenCoils = {1, 0, 1, 1, 0, 0, 1, 1, 1, 0};

/// The values that an answer gives to so many places.
std::vector<std::uint16_t> taken(Table table, std::size_t places, const Octets& answer) {
  Exchange e{1, table, false, 0, std::vector<std::uint16_t>(places)};
  return take_read(answer.data(), answer.size(), e) ? e.values : std::vector<std::uint16_t>{};
}

}  // namespace

TEST_CASE("Reads of each table have its function") {
  const auto request = [](Table table) {
    return request_pdu({1, table, false, 0x13, std::vector<std::uint16_t>(0x125)});
  };
  CHECK(request(Table::kCoil) == Octets{1, 0x00, 0x13, 0x01, 0x25});
  CHECK(request(Table::kDiscrete) == Octets{2, 0x00, 0x13, 0x01, 0x25});
  CHECK(request(Table::kHolding) == Octets{3, 0x00, 0x13, 0x01, 0x25});
  CHECK(request(Table::kInput) == Octets{4, 0x00, 0x13, 0x01, 0x25});
}

TEST_CASE("6.1: coils 20 to 38 in an answer") {
  const std::vector<std::uint16_t> coils = {1, 0, 1, 1, 0, 0, 1, 1, 1, 1, 0, 1, 0, 1, 1, 0, 1, 0, 1};
  const Octets answer = {1, 3, 0xCD, 0x6B, 0x05};
  CHECK(answer_pdu({1, Table::kCoil, false, 0x13, coils}) == answer);
  CHECK(taken(Table::kCoil, 19, answer) == coils);
}

TEST_CASE("6.3: registers 108 to 110 in an answer") {
  const std::vector<std::uint16_t> registers = {0x022B, 0, 0x64};
  const Octets answer = {3, 6, 0x02, 0x2B, 0x00, 0x00, 0x00, 0x64};
  CHECK(answer_pdu({1, Table::kHolding, false, 0x6B, registers}) == answer);
  CHECK(taken(Table::kHolding, 3, answer) == registers);
}

TEST_CASE("6.11 and 6.12: coils and registers are written, and the answer repeats the place") {
  const Exchange coils{1, Table::kCoil, true, 0x13, kTenCoils};
  CHECK(request_pdu(coils) == Octets{15, 0x00, 0x13, 0x00, 0x0A, 2, 0xCD, 0x01});
  CHECK(answer_pdu(coils) == Octets{15, 0x00, 0x13, 0x00, 0x0A});
  const Exchange registers{1, Table::kHolding, true, 0x1234, {0x000A, 0x0102}};
  CHECK(request_pdu(registers) == Octets{16, 0x12, 0x34, 0x00, 0x02, 4, 0x00, 0x0A, 0x01, 0x02});
  CHECK(answer_pdu(registers) == Octets{16, 0x12, 0x34, 0x00, 0x02});
}

TEST_CASE("Bits fill whole octets, with zeros behind them") {
  for (std::size_t n = 1; n <= 24; ++n) {
    const Octets answer = answer_pdu({1, Table::kDiscrete, false, 0, std::vector<std::uint16_t>(n, 1)});
    CHECK(answer.size() == 2 + (n + 7) / 8);
    CHECK(answer[1] == (n + 7) / 8);
    CHECK(answer.back() == (n % 8 == 0 ? 0xff : (1 << n % 8) - 1));
    CHECK(taken(Table::kDiscrete, n, answer) == std::vector<std::uint16_t>(n, 1));
  }
}

TEST_CASE("An answer of another length than was asked for is none") {
  for (const Octets& wrong : {Octets{3, 4, 0, 1, 0}, Octets{3, 4, 0, 1, 0, 2, 0}, Octets{3, 2, 0, 1, 0, 2},
                              Octets{3, 2, 0, 1}, Octets{3}})
    CHECK(taken(Table::kHolding, 2, wrong).empty());
  CHECK(taken(Table::kHolding, 2, {3, 4, 0, 1, 0, 2}) == std::vector<std::uint16_t>{1, 2});
}
