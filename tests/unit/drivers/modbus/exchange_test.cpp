#include "rigsound/modbus/exchange.hpp"

#include <doctest/doctest.h>

#include "drivers/modbus/bus_harness.hpp"
#include "modbus/poll_plan.hpp"

using namespace rigsound;
using namespace rigsound::modbus;

namespace {

double decoded(WordType type, WordOrder order, std::vector<std::uint16_t> words) {
  return decode(route(Signal::kEngineRpm, Table::kHolding, 0, type, order), words.data());
}

}  // namespace

TEST_CASE("Every word type in every word order") {
  // 499.375 = 0x43F9B000, -2 = 0xFFFFFFFE, 0x12345678 = 305419896
  struct Case {
    WordOrder order;
    std::uint16_t real[2], negative[2], number[2], small;
  };
  for (const Case& c :
       {Case{WordOrder::kAbcd, {0x43F9, 0xB000}, {0xFFFF, 0xFFFE}, {0x1234, 0x5678}, 0x0102},
        Case{WordOrder::kCdab, {0xB000, 0x43F9}, {0xFFFE, 0xFFFF}, {0x5678, 0x1234}, 0x0102},
        Case{WordOrder::kBadc, {0xF943, 0x00B0}, {0xFFFF, 0xFEFF}, {0x3412, 0x7856}, 0x0201},
        Case{WordOrder::kDcba, {0x00B0, 0xF943}, {0xFEFF, 0xFFFF}, {0x7856, 0x3412}, 0x0201}}) {
    CAPTURE(static_cast<int>(c.order));
    CHECK(decoded(WordType::kFloat32, c.order, {c.real[0], c.real[1]}) == 499.375);
    CHECK(decoded(WordType::kInt32, c.order, {c.negative[0], c.negative[1]}) == -2);
    CHECK(decoded(WordType::kUint32, c.order, {c.number[0], c.number[1]}) == 305419896);
    CHECK(decoded(WordType::kUint16, c.order, {c.small}) == 0x0102);
  }
  CHECK(decoded(WordType::kInt16, WordOrder::kAbcd, {0xFFFF}) == -1);
}

TEST_CASE("Values of four words in every word order") {
  // 499.375 as a double is 0x407F360000000000
  const std::vector<std::uint16_t> abcd = {0x407F, 0x3600, 0, 0}, number = {0x0000, 0x0001, 0x0203, 0x0405};
  const auto reversed = [](std::vector<std::uint16_t> words) {
    return std::vector<std::uint16_t>(words.rbegin(), words.rend());
  };
  const auto swapped = [](std::vector<std::uint16_t> words) {
    for (std::uint16_t& word : words) word = static_cast<std::uint16_t>(word << 8 | word >> 8);
    return words;
  };
  CHECK(decoded(WordType::kFloat64, WordOrder::kAbcd, abcd) == 499.375);
  CHECK(decoded(WordType::kFloat64, WordOrder::kCdab, reversed(abcd)) == 499.375);
  CHECK(decoded(WordType::kFloat64, WordOrder::kBadc, swapped(abcd)) == 499.375);
  CHECK(decoded(WordType::kFloat64, WordOrder::kDcba, swapped(reversed(abcd))) == 499.375);
  CHECK(decoded(WordType::kUint64, WordOrder::kAbcd, number) == 0x000102030405);
  CHECK(decoded(WordType::kInt64, WordOrder::kAbcd, {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFE}) == -2);
  CHECK(decoded(WordType::kUint64, WordOrder::kAbcd, {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}) ==
        18446744073709551615.0);
}

TEST_CASE("Some bits of a status word, and a table of values") {
  RegisterRoute status = route(Signal::kPercussion, Table::kHolding, 0);
  status.mask = 0x0008;
  const std::uint16_t on = 0xFFFF, off = 0xFFF7;
  CHECK(decode(status, &on) == 1);
  CHECK(decode(status, &off) == 0);
  status.mask = 0x0F00;
  const std::uint16_t word = 0xA5C3;
  CHECK(decode(status, &word) == 5);
  status.target = {Signal::kRattling};
  status.values = {{0, 0}, {5, 2}};
  CHECK(decode(status, &word) == 2);
  Exchange exchange;
  exchange.values = {0xA6C3};  // 6 is none of its values
  std::vector<Reading> found;
  readings(exchange, {status}, 1, found);
  REQUIRE(found.size() == 1);
  CHECK(found[0].validity == Validity::kOutOfRange);
  CHECK(found[0].value == 6);
  RegisterRoute wide = route(Signal::kRock, Table::kHolding, 0, WordType::kUint32, WordOrder::kCdab);
  wide.mask = 0x00FF0000;
  const std::uint16_t two[] = {0x5678, 0x1234};
  CHECK(decode(wide, two) == 0x34);
}

TEST_CASE("An exchange gives a reading for each route wholly inside it") {
  const std::vector<RegisterRoute> routes = {
      route(Signal::kEngineRpm, Table::kHolding, 10, WordType::kFloat32),
      route(Signal::kFeedPressureBar, Table::kHolding, 12), route(Signal::kPercussion, Table::kCoil, 12)};
  Exchange exchange;
  exchange.address = 11;
  exchange.values = {0xB000, 85, 7};
  std::vector<Reading> found;
  readings(exchange, routes, 3.5, found);
  REQUIRE(found.size() == 1);
  CHECK(found[0].id.signal == Signal::kFeedPressureBar);
  CHECK(found[0].value == 85);
  CHECK(found[0].time_s == 3.5);
}

TEST_CASE("Addresses are told as on the wire and as in the field's manuals") {
  CHECK(describe(Table::kHolding, 0) == "holding 0 = 40001");
  CHECK(describe(Table::kInput, 7) == "input 7 = 30008");
  CHECK(describe(Table::kCoil, 2) == "coil 2 = 3");
  CHECK(describe(Table::kDiscrete, 0) == "discrete 0 = 10001");
}

TEST_CASE("Near registers share a request, far ones and other tables do not, none exceeds 125") {
  const auto holding = [](std::uint16_t address) {
    return route(Signal::kEngineRpm, Table::kHolding, address);
  };
  const auto plan = poll_plan({holding(20), holding(0), holding(9), route(Signal::kRock, Table::kInput, 1),
                               route(Signal::kRock, Table::kHolding, 28, WordType::kFloat32)});
  REQUIRE(plan.size() == 3);
  CHECK(plan[0].address == 0);
  CHECK(plan[0].count == 10);
  CHECK(plan[1].address == 20);
  CHECK(plan[1].count == 10);
  CHECK(plan[2].table == Table::kInput);

  std::vector<RegisterRoute> many;
  for (std::uint16_t a = 0; a < 1000; ++a) many.push_back(holding(a));
  int total = 0;
  for (const PollRequest& r : poll_plan(many)) {
    CHECK(r.count <= 125);
    total += r.count;
  }
  CHECK(total == 1000);
}
