// What is told of a recorded bus besides its values: what was passed over, and nothing else.
#include "rigsound/log/can_log.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "rigsound/machine/signal_board.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

/// Notes of a log of these lines, all read.
std::vector<std::string> all_can_notes(const std::string& lines, bool fd) {
  const test::TemporaryFolder folder;
  can::SignalRoute feed;
  feed.target = {Signal::kFeedPositionM};
  feed.match.id = 0x123;
  feed.layout.field = {0, 8, can::ByteOrder::kIntel};
  can::CanOptions bus;
  bus.interface = "can0";
  bus.fd = fd;
  bus.routes = {feed};
  log::CanLog log(log::LogFile(folder.write("log", lines)), {bus}, {});
  SignalBoard board;
  log.read_until(1e9, board);
  std::vector<std::string> texts;
  for (const log::LogNote& note : log.notes()) texts.push_back(note.text);
  REQUIRE(!texts.empty());
  return texts;
}

/// But for the first: how many frames there were.
std::vector<std::string> can_notes(const std::string& lines, bool fd) {
  std::vector<std::string> texts = all_can_notes(lines, fd);
  texts.erase(texts.begin());
  return texts;
}

}  // namespace

TEST_CASE("A log of which every line was used has no note of what was not") {
  const std::string lines = "(1.000000) can0 123#03\n(1.100000) can0 123#04\n";
  CHECK(can_notes(lines, false).empty());
  CHECK(can_notes(lines + "(1.200000) can0 123##105\n", true).empty());
}

TEST_CASE("Lines that are no frame, error frames and CAN FD frames that the rig does not take are counted") {
  const std::string good = "(1.000000) can0 123#03\n(1.100000) can0 123#04\n";
  using Texts = std::vector<std::string>;
  CHECK(can_notes(good + "nonsense\n(1.200000) can0 123#05\n", false) ==
        Texts{"skipped 1 lines that are no frame"});
  CHECK(can_notes(good + "(1.200000) can0 20000004#0000000000000000\n", false) == Texts{"1 error frames"});
  CHECK(can_notes(good + "(1.200000) can0 123##105\n(1.300000) can0 123##106\n", false) ==
        Texts{"2 CAN FD frames of the rig's messages were not taken: fd = true?"});
}

TEST_CASE("A frame is used when one of its signals is taken") {
  const std::string taken = "(1.000000) can0 123#03\n(1.500000) can0 123#04\n";
  const std::string foreign = "(2.000000) can0 124#05\n", out_of_range = "(3.000000) can0 123#FF\n";
  CHECK(all_can_notes(taken + foreign + out_of_range, false).front() == "4 frames in 2.0 s, 2 used");
}
