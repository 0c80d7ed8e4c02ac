// A table of states acts block by block, as its times say.
#include "rigsound/session/table_states.hpp"

#include <doctest/doctest.h>

#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

struct TableFile {
  explicit TableFile(const std::string& rows)
      : file(folder.write("states.csv", "time_s,signal,value\n" + rows)) {}
  test::TemporaryFolder folder;
  std::filesystem::path file;
};

EngineOptions two_booms() {
  EngineOptions options;
  options.booms = {{"left"}, {"right"}};
  return options;
}

}  // namespace

TEST_CASE("a row acts from the block on that begins at its time or later, rounded to a microsecond") {
  // Blocks of 64 at 48 kHz begin at 0, 0.001333..., 0.002666..., printed as 0.002667, 0.004.
  const TableFile table(
      "0,engine_rpm,1500\n0.001333,left.feed_pressure_bar,90\n0.002667,right.rattling,open\n"
      "0.003,feed_pressure_bar,95\n");
  session::TableStates states(table.file, two_booms());
  CHECK(states.state_of(0)->engine_rpm == 1500);
  CHECK(states.state_of(0)->boom[0].feed_pressure_bar == 0);
  CHECK(states.state_of(1)->boom[0].feed_pressure_bar == 90);
  CHECK(states.state_of(1)->boom[1].rattling == Rattling::kNone);
  CHECK(states.state_of(2)->boom[1].rattling == Rattling::kOpen);
  CHECK(states.state_of(2)->boom[0].feed_pressure_bar == 90);
  REQUIRE(states.state_of(3) != nullptr);
  CHECK(states.state_of(3) == nullptr);  // the last row has acted
}

TEST_CASE("a table that names a boom of another rig is refused with the rig's names") {
  const TableFile table("0,middle.feed_pressure_bar,90\n");
  CHECK_THROWS_WITH_AS(session::TableStates(table.file, two_booms()),
                       doctest::Contains("no boom 'middle', expected one of: left, right"), InputError);
}
