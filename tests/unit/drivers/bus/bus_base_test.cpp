// What every bus does about a device that cannot be opened.
#include "bus/bus_base.hpp"

#include <doctest/doctest.h>

#include "drivers/modbus/bus_harness.hpp"

using namespace rigsound;

namespace {

struct ClosedBus : BusBase {
  explicit ClosedBus(BusListener& listener) : BusBase("closed", {}, listener) {}
  void step() override {}
  std::vector<BusCounter> counters() const override { return {}; }
  using BusBase::may_open;
  using BusBase::open_failed;
};

}  // namespace

TEST_CASE("a device that could not be opened is not tried before its pause is over, and told once") {
  modbus::Told told;
  ClosedBus bus(told);
  bus.stop();  // nobody waits for the pause
  CHECK(bus.may_open());
  std::int64_t pause_ms = 0;
  for (int i = 0; i < 10; ++i) pause_ms = bus.open_failed("it is not there");
  CHECK(pause_ms == 5000);
  CHECK_FALSE(bus.may_open());
  CHECK(told.notices() == 1);
  bus.open_failed("it is busy");
  CHECK(told.notices() == 2);
}
