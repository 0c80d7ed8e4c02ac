#include "modbus/request.hpp"

#include <doctest/doctest.h>

#include <random>

#include "drivers/modbus/bus_harness.hpp"
#include "modbus/register_file.hpp"

using namespace rigsound;
using namespace rigsound::modbus;

namespace {

using Pdu = std::vector<std::uint8_t>;

const std::vector<Pdu> kGood = {{1, 0, 0, 0, 9},
                                {2, 0, 0, 0, 1},
                                {3, 0, 0, 0, 125},
                                {4, 0, 0, 0, 1},
                                {5, 0, 0, 0xff, 0},
                                {6, 0, 0, 0, 85},
                                {15, 0, 0, 0, 9, 2, 0xff, 1},
                                {16, 0, 0, 0, 2, 4, 1, 2, 3, 4},
                                {22, 0, 0, 0, 0xf0, 0, 1},
                                {23, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 7}};

std::optional<Refusal> parsed(const Pdu& pdu) {
  Request request;
  return parse(pdu.data(), pdu.size(), request);
}

}  // namespace

TEST_CASE("Each function is taken at its exact length and at no other") {
  for (const Pdu& good : kGood) {
    CAPTURE(static_cast<int>(good[0]));
    CHECK_FALSE(parsed(good).has_value());
    Pdu longer = good;
    longer.push_back(0);
    CHECK(parsed(longer) == Refusal::kValue);
    for (std::size_t n = 1; n < good.size(); ++n)
      CHECK(parsed(Pdu(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(n))) == Refusal::kValue);
  }
}

TEST_CASE("Counts of zero, counts over the protocol's, wrong byte counts and unknown functions are refused") {
  for (const Pdu& bad : {Pdu{1, 0, 0, 0, 0}, Pdu{1, 0, 0, 7, 0xd1}, Pdu{3, 0, 0, 0, 0}, Pdu{3, 0, 0, 0, 126},
                         Pdu{3, 0xff, 0xff, 0, 2}, Pdu{5, 0, 0, 1, 0}, Pdu{15, 0, 0, 0, 9, 1, 0xff},
                         Pdu{16, 0, 0, 0, 2, 2, 1, 2}, Pdu{23, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0, 7}})
    CHECK(parsed(bad) == Refusal::kValue);
  for (const int function : {0, 7, 8, 17, 20, 24, 43, 0x83, 255})
    CHECK(parsed({static_cast<std::uint8_t>(function), 0, 0, 0, 1}) == Refusal::kFunction);
}

TEST_CASE("Random bytes never pass with more values than they carry") {
  std::mt19937 random(1);
  int passed = 0;
  for (int i = 0; i < 200000; ++i) {
    Pdu pdu(1 + random() % 30);
    for (std::uint8_t& b : pdu) b = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : random() % 24);
    Request r;
    if (parse(pdu.data(), pdu.size(), r)) continue;
    ++passed;
    if (r.write && !r.masked) CHECK(static_cast<int>(r.values.size()) == r.write->count);
    if (r.read) CHECK(r.read->count <= 2000);
  }
  CHECK(passed > 0);
}

TEST_CASE("Reads may span the rig's addresses, writes must hit them whole and in range") {
  const RegisterFile file(
      {route(Signal::kFeedPressureBar, Table::kHolding, 10, WordType::kUint16),
       route(Signal::kEngineRpm, Table::kHolding, 12, WordType::kFloat32),
       route(Signal::kPercussion, Table::kCoil, 3), route(Signal::kPercussionRateHz, Table::kHolding, 20),
       route(Signal::kRattling, Table::kHolding, 21, WordType::kUint16, WordOrder::kAbcd, 0.5)});
  const auto checked = [&](const Pdu& pdu) {
    Request request;
    Exchange change;
    REQUIRE_FALSE(parse(pdu.data(), pdu.size(), request).has_value());
    return file.check(request, change);
  };
  CHECK_FALSE(checked({3, 0, 10, 0, 4}).has_value());  // the gap at 11 reads 0
  CHECK(checked({3, 0, 9, 0, 2}) == Refusal::kAddress);
  CHECK(checked({3, 0, 21, 0, 2}) == Refusal::kAddress);
  CHECK(checked({4, 0, 10, 0, 1}) == Refusal::kAddress);  // no input registers here
  CHECK(checked({2, 0, 3, 0, 1}) == Refusal::kAddress);
  CHECK_FALSE(checked({6, 0, 10, 0, 85}).has_value());
  CHECK(checked({6, 0, 11, 0, 85}) == Refusal::kAddress);     // nothing lives in the gap
  CHECK(checked({6, 0, 10, 1, 45}) == Refusal::kValue);       // 301 bar
  CHECK(checked({6, 0, 12, 0x43, 0xF9}) == Refusal::kValue);  // half a float
  CHECK_FALSE(checked({16, 0, 12, 0, 2, 4, 0x43, 0xF9, 0xB0, 0}).has_value());
  CHECK(checked({16, 0, 12, 0, 2, 4, 0x7f, 0xc0, 0, 0}) == Refusal::kValue);  // NaN
  CHECK(checked({16, 0, 12, 0, 2, 4, 0x7f, 0x80, 0, 0}) == Refusal::kValue);  // infinity
  CHECK_FALSE(checked({5, 0, 3, 0xff, 0}).has_value());
  CHECK(checked({5, 0, 4, 0xff, 0}) == Refusal::kAddress);
  CHECK_FALSE(checked({6, 0, 20, 0, 40}).has_value());
  CHECK_FALSE(checked({6, 0, 20, 0, 0}).has_value());   // 0 Hz: none given
  CHECK(checked({6, 0, 20, 0, 4}) == Refusal::kValue);  // under 5 Hz
  CHECK_FALSE(checked({6, 0, 21, 0, 2}).has_value());   // 1: closed
  CHECK(checked({6, 0, 21, 0, 3}) == Refusal::kValue);  // 1.5 is no word
}
