#include "can/kernel_format.hpp"

#include <doctest/doctest.h>

#include "can/kernel_format.hpp"

using namespace rigsound::can;

namespace {

bool passes(const std::vector<can_filter>& filters, canid_t id) {
  for (const can_filter& f : filters)
    if ((id & f.can_mask) == (f.can_id & f.can_mask)) return true;
  return false;
}

MessageMatch j1939(std::uint32_t id) {
  MessageMatch m;
  m.id = id;
  m.extended = m.j1939 = true;
  return m;
}

}  // namespace

TEST_CASE("A plain message passes by its identifier, its frame format and only as data") {
  MessageMatch standard, extended;
  standard.id = extended.id = 0x123;
  extended.extended = true;
  CHECK(passes(kernel_filters({standard}), 0x123));
  CHECK_FALSE(passes(kernel_filters({standard}), 0x124));
  CHECK_FALSE(passes(kernel_filters({standard}), 0x123 | CAN_EFF_FLAG));
  CHECK_FALSE(passes(kernel_filters({standard}), 0x123 | CAN_RTR_FLAG));
  CHECK(passes(kernel_filters({extended}), 0x123 | CAN_EFF_FLAG));
  CHECK_FALSE(passes(kernel_filters({extended}), 0x123));
  CHECK(kernel_filters({standard, standard, extended}).size() == 2);
}

TEST_CASE("A J1939 message passes by its PGN, from any source unless one is named") {
  const auto eec1 = kernel_filters({j1939(0x0CF00400)});
  CHECK(passes(eec1, 0x0CF00400 | CAN_EFF_FLAG));
  CHECK(passes(eec1, 0x18F00421 | CAN_EFF_FLAG));        // another priority and source
  CHECK_FALSE(passes(eec1, 0x0CF00500 | CAN_EFF_FLAG));  // PF 240: PS belongs to the PGN
  CHECK_FALSE(passes(eec1, 0x0DF00400 | CAN_EFF_FLAG));  // data page 1
  MessageMatch named = j1939(0x0CF00400);
  named.source = 0x21;
  CHECK(passes(kernel_filters({named}), 0x18F00421 | CAN_EFF_FLAG));
  CHECK_FALSE(passes(kernel_filters({named}), 0x0CF00400 | CAN_EFF_FLAG));
  const auto addressed = kernel_filters({j1939(0x18EF0000)});  // PF 239: PS is a destination
  CHECK(passes(addressed, 0x18EF2133 | CAN_EFF_FLAG));
  CHECK_FALSE(passes(addressed, 0x18EE0000 | CAN_EFF_FLAG));
}
