// Recorded datagrams: onto the board at their times, counted, and explained where none is of use.
#include "rigsound/log/udp_log.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/log/udp_capture_writer.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::log;

namespace {

constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;

udp::UdpOptions input(int port) {
  udp::UdpOptions options;
  options.port = port;
  options.address = "127.0.0.1:" + std::to_string(port);
  options.routes = {{{Signal::kEngineRpm}, "engine_rpm", "boom1.engine_rpm"},
                    {{Signal::kRodCount, 1}, "boom2.rod_count", ""}};
  return options;
}

struct Said {
  double at_s;
  int port;
  std::string text;
};

/// A capture of what was said.
struct Recorded {
  explicit Recorded(const std::vector<Said>& all) {
    UdpCaptureWriter writer(file);
    for (const Said& said : all)
      writer.write(kStart_ns + static_cast<std::int64_t>(said.at_s * 1e9), said.port, said.text);
    writer.flush();
  }
  UdpLog log(const std::vector<udp::UdpOptions>& inputs = {input(1503)}) const {
    return UdpLog(LogFile(file), inputs, {});
  }
  std::string refusal() const {
    const std::string said = test::complaint([&] { log(); });
    CHECK(said.rfind(file.string() + ": ", 0) == 0);
    return said.substr(std::min(said.size(), file.string().size() + 2));
  }

  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path / "udp.pcap";
};

std::vector<std::string> texts(const UdpLog& log) {
  std::vector<std::string> all;
  for (const LogNote& note : log.notes()) all.push_back(note.text);
  return all;
}

}  // namespace

TEST_CASE("Datagrams play onto the board at their times, each once") {
  const Recorded recorded({{0, 1503, R"({"engine_rpm": 800})"},
                           {1.5, 1503, R"({"engine_rpm": 900, "boom2": {"rod_count": 3}})"},
                           {2, 7, R"({"engine_rpm": 3000})"},  // to another port
                           {2.5, 1503, R"({"engine_rpm": 1000})"}});
  UdpLog log = recorded.log();
  SignalBoard board;
  CHECK(*log.next_s() == 0);
  CHECK(log.read_until(0, board));
  CHECK(board.entry({Signal::kEngineRpm}).value == 800);
  CHECK(*log.next_s() == doctest::Approx(1.5));
  CHECK_FALSE(log.read_until(1.4, board));
  CHECK(log.read_until(2.2, board));
  CHECK(board.entry({Signal::kEngineRpm}).value == 900);
  CHECK(board.entry({Signal::kEngineRpm}).seen_s == doctest::Approx(1.5));
  CHECK(board.entry({Signal::kRodCount, 1}).value == 3);
  CHECK(log.read_until(99, board));
  CHECK(board.entry({Signal::kEngineRpm}).value == 1000);
  CHECK_FALSE(log.next_s());
  CHECK_FALSE(log.read_until(999, board));
  CHECK(log.share() == 1);
  CHECK(texts(log) == std::vector<std::string>{"3 datagrams in 2.5 s, 3 used"});
}

TEST_CASE("What is no object, late, unknown or out of range is counted and told") {
  const Recorded recorded({{0, 1503, R"({"engine_rpm": 800, "seq": 7})"},
                           {0.25, 1503, "hello"},
                           {0.5, 1503, R"({"engine_rpm": 700, "seq": 6})"},
                           {0.75, 1503, R"({"engine_rmp": 1, "rods": 2, "engine_rpm": 900})"},
                           {1, 1503, R"({"drill": 1})"},
                           {1.25, 1503, R"({"engine_rpm": 99999})"},
                           {1.5, 1503, R"({"engine_rpm": 850, "seq": 8})"}});
  UdpLog log = recorded.log();
  SignalBoard board;
  log.read_until(0.6, board);
  CHECK(board.entry({Signal::kEngineRpm}).value == 800);
  log.read_until(9, board);
  CHECK(board.entry({Signal::kEngineRpm}).value == 850);
  CHECK(texts(log) ==
        std::vector<std::string>{"7 datagrams in 1.5 s, 3 used", "1 datagrams are no JSON object of signals",
                                 "1 datagrams came after a newer one and were left out",
                                 "3 names are no signal of the rig, the first is 'engine_rmp'"});
}

TEST_CASE("With several inputs each gets the datagrams of its port, and its own numbers") {
  udp::UdpOptions second = input(1504);
  second.routes = {{{Signal::kEngineRpm}, "rpm", ""}};
  const Recorded recorded({{0, 1503, R"({"boom2.rod_count": 4, "seq": 100})"},
                           {1, 1504, R"({"rpm": 700, "seq": 5})"},
                           {2, 1504, R"({"boom2.rod_count": 9, "seq": 6})"}});
  UdpLog log = recorded.log({input(1503), second});
  SignalBoard board;
  CHECK(log.read_until(1, board));
  CHECK_FALSE(log.read_until(9, board));
  CHECK(board.entry({Signal::kEngineRpm}).value == 700);
  CHECK(board.entry({Signal::kRodCount, 1}).value == 4);
  CHECK(texts(log) == std::vector<std::string>{"3 datagrams in 2.0 s, 2 used",
                                               "1 names are no signal of the rig, the first is "
                                               "'boom2.rod_count'"});
}

TEST_CASE("One input takes the JSON of another port where there is none to its own") {
  const Recorded recorded(
      {{0, 9, R"({"engine_rpm": 700})"}, {1, 8, "no JSON"}, {2, 9, R"({"engine_rpm": 750})"}});
  UdpLog log = recorded.log();
  SignalBoard board;
  CHECK(log.read_until(9, board));
  CHECK(board.entry({Signal::kEngineRpm}).value == 750);
  CHECK(texts(log) == std::vector<std::string>{"2 datagrams in 2.0 s, 2 used"});
}

TEST_CASE("A capture without anything of use is refused with what comes nearest") {
  CHECK(Recorded({{0, 1504, "x"}}).refusal() ==
        "holds no datagram to 127.0.0.1:1503, expected those of the [[udp]]");
  CHECK(Recorded({{0, 1503, R"({"drill": 1})"}, {1, 1503, R"({"rods": 1})"}, {2, 1503, "x"}}).refusal() ==
        "none of its 3 datagrams is of use to the rig: 'drill' is no signal of the rig");
  CHECK(
      Recorded({{0, 1503, R"({"drill": 1, "boom2.rod_count": 50})"}, {1, 1503, R"({"boom2.rod_count": 60})"}})
          .refusal() == "none of its 2 datagrams is of use to the rig: rod_count is 50, which it cannot be");
  CHECK(Recorded({{0, 1503, "{}"}}).refusal() ==
        "none of its 1 datagrams is of use to the rig: they are empty");
  CHECK(Recorded({{0, 1503, "x"}})
            .refusal()
            .rfind("none of its 1 datagrams is of use to the rig: they are no JSON object of signals: ", 0) ==
        0);
}
