// An interface that goes, comes back, overflows and reports errors.
#include "can/can_bus.hpp"

#include <doctest/doctest.h>
#include <linux/can/error.h>

#include <cerrno>
#include <chrono>
#include <deque>

#include "rigsound/can/frame_decoder.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/machine/signal_board.hpp"
#include "rigsound/monotonic_time.hpp"

using namespace rigsound;
using namespace rigsound::can;

namespace {

struct Script {
  std::deque<int> answers;           // of receive(): frames, or a negative errno value
  std::deque<std::string> refusals;  // of open(): a reason, or empty for success
  std::vector<Frame> frames;         // what the next receive() delivers
  std::uint64_t dropped = 0;
  std::vector<int> waits;
  double realtime_s = 0;  // stamp of every frame
  CanSocketOptions opened_with;
};

class ScriptedSocket : public CanSocket {
 public:
  explicit ScriptedSocket(Script& script) : script_(script) {}
  int receive(Arrival* out, std::size_t, int, const StopEvent&) override {
    const int answer = script_.answers.front();
    script_.answers.pop_front();
    for (int i = 0; i < answer; ++i) out[i] = {script_.frames[i], script_.realtime_s};
    return answer;
  }
  std::uint64_t dropped() const override { return script_.dropped; }

 private:
  Script& script_;
};

class ScriptedPort : public CanPort {
 public:
  explicit ScriptedPort(Script& script) : script_(script) {}
  std::unique_ptr<CanSocket> open(const CanSocketOptions& options) override {
    const std::string refusal = script_.refusals.empty() ? "" : script_.refusals.front();
    if (!script_.refusals.empty()) script_.refusals.pop_front();
    if (!refusal.empty()) throw DeviceError(refusal);
    script_.opened_with = options;
    return std::make_unique<ScriptedSocket>(script_);
  }
  void wait_for_change(int timeout_ms, const StopEvent&) override { script_.waits.push_back(timeout_ms); }

 private:
  Script& script_;
};

struct Story : BusListener, CanTap {
  void traffic(const Arrival* first, std::size_t count) override {
    told.push_back("frames " + std::to_string(count) + " from " + std::to_string(first->frame.id));
  }
  void readings(const Reading* first, std::size_t count) override {
    heard.insert(heard.end(), first, first + count);
  }
  void up() override { told.emplace_back("up"); }
  void down(const std::string& why) override { told.push_back("down " + why.substr(0, 20)); }
  void notice(const std::string& text) override { told.push_back("notice " + text); }
  std::vector<std::string> told;
  std::vector<Reading> heard;
};

/// Feed pressure in the first byte of frames 7, rod count in the second.
CanOptions options() {
  CanOptions o;
  o.interface = "can0";
  SignalRoute pressure;
  pressure.target = {Signal::kFeedPressureBar, 1};
  pressure.match.id = 7;
  pressure.layout.field = {0, 8, ByteOrder::kIntel};
  SignalRoute rods = pressure;
  rods.target = {Signal::kRodCount, 1};
  rods.layout.field.start_bit = 8;
  o.routes = {pressure, rods};
  return o;
}

struct Setup {
  void steps(int count) {
    for (int i = 0; i < count; ++i) bus.step();
  }
  std::uint64_t count(std::string_view name) const {
    for (const BusCounter& counter : bus.counters())
      if (counter.name == name) return counter.count;
    FAIL("no counter of that name");
    return 0;
  }
  Script script;
  Story story;
  CanBus bus{options(), story, &story, std::make_unique<ScriptedPort>(script)};
};

double realtime_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

Frame data(std::uint32_t id) {
  Frame f;
  f.id = id;
  f.size = 8;
  return f;
}

Frame error(std::uint32_t classes, std::uint8_t controller = 0) {
  Frame f = data(classes);
  f.error = true;
  f.data[1] = controller;
  return f;
}

}  // namespace

TEST_CASE("A missing interface is told once and looked for with pauses from 0.1 s doubling to 5 s") {
  Setup s;
  s.script.refusals.assign(9, "CAN interface can0 does not exist");
  s.steps(10);
  CHECK(s.script.waits == std::vector<int>{100, 200, 400, 800, 1600, 3200, 5000, 5000, 5000});
  CHECK(s.story.told == std::vector<std::string>{"notice CAN interface can0 does not exist", "up"});
}

TEST_CASE("A lost interface is told, left and opened again, whatever the reason") {
  for (const int reason : {ENETDOWN, ENODEV, EBADF}) {
    Setup s;
    s.script.answers = {0, -reason, 1};
    s.script.frames = {data(7)};
    s.steps(5);
    REQUIRE(s.story.told.size() == 4);
    CHECK(s.story.told[0] == "up");
    CHECK(s.story.told[1].substr(0, 10) == "down can0:");
    CHECK(s.story.told[2] == "up");
    CHECK(s.story.told[3] == "frames 1 from 7");
    CHECK(s.count("losses") == 1);
  }
}

TEST_CASE("Data and error frames are told apart in order, drops are counted over reopenings") {
  Setup s;
  s.script.answers = {5, -ENETDOWN, 0};
  s.script.frames = {data(1), data(2), error(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_PASSIVE), data(3),
                     error(CAN_ERR_CRTL)};
  s.script.dropped = 11;
  s.steps(5);
  REQUIRE(s.story.told.size() == 6);
  CHECK(s.story.told[1] == "frames 2 from 1");
  CHECK(s.story.told[2].find("error-passive") != std::string::npos);
  CHECK(s.story.told[3] == "frames 1 from 3");
  CHECK(s.count("frames_seen") == 3);
  CHECK(s.count("frames_used") == 0);
  CHECK(s.count("frames_bad") == 2);
  CHECK(s.count("frames_dropped") == 22);  // 11 on each of two sockets
}

TEST_CASE("A controller that reports its trouble again and again is told once a minute at most") {
  Setup s;
  s.script.frames.assign(200, error(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE));
  s.script.answers = {200, 200, 200};
  s.steps(4);
  CHECK(s.story.told.size() == 2);
  CHECK(s.count("frames_bad") == 600);
}

TEST_CASE("Bus-off takes the bus down once, with the fix, until the controller restarts") {
  Setup s;
  s.script.answers = {1, 1, 1};
  s.script.frames = {error(CAN_ERR_BUSOFF)};
  s.steps(3);
  s.script.frames = {error(CAN_ERR_RESTARTED)};
  s.steps(1);
  CHECK(s.story.told == std::vector<std::string>{"up", "down can0: the controller", "up"});
}

TEST_CASE("A frame is decoded, and its reading carries the time the kernel stamped, on the readings' clock") {
  Setup s;
  Frame frame = data(7);
  frame.data[0] = 85;
  frame.data[1] = 3;
  s.script.frames = {data(6), frame};
  s.script.answers = {2};
  const double before_s = monotonic_s();
  s.script.realtime_s = realtime_s() - 0.25;
  s.steps(2);
  const double after_s = monotonic_s();
  REQUIRE(s.story.heard.size() == 2);
  CHECK(s.story.heard[0].id.signal == Signal::kFeedPressureBar);
  CHECK(s.story.heard[0].id.boom == 1);
  CHECK(s.story.heard[0].value == 85);
  CHECK(s.story.heard[1].value == 3);
  for (const Reading& reading : s.story.heard) {
    CHECK(reading.validity == Validity::kValid);
    CHECK(reading.time_s > before_s - 0.25 - 0.01);  // the clocks are read one after the other, and slewed
    CHECK(reading.time_s < after_s - 0.25 + 0.01);
  }
  CHECK(s.count("frames_used") == 1);
}

TEST_CASE("Only frames of the routes are decoded, each by all of its routes") {
  SignalRoute pressure = options().routes[0], rods = options().routes[1], other = rods;
  other.match.id = 9;
  std::vector<SignalRoute> routes = {pressure, rods, other};
  routes.pop_back();  // what lies behind the last route is none
  const FrameDecoder decoder(std::move(routes));
  std::vector<Reading> readings;
  CHECK_FALSE(decoder.decode(data(9), 1, readings));
  CHECK(readings.empty());
  Frame frame = data(7);
  frame.data[0] = 85, frame.data[1] = 3;
  CHECK(decoder.decode(frame, 1.5, readings));
  REQUIRE(readings.size() == 2);
  CHECK(readings[0].value == 85);
  CHECK(readings[1].value == 3);
  CHECK(readings[1].time_s == 1.5);
}

TEST_CASE("A frame without a stamp counts as of now, one of the future or of long ago within a second") {
  for (const double age_s : {0.0, -100.0, 100.0}) {
    CAPTURE(age_s);
    Setup s;
    s.script.frames = {data(7)};
    s.script.answers = {1};
    s.script.realtime_s = age_s == 0 ? 0 : realtime_s() - age_s;
    const double before_s = monotonic_s();
    s.steps(2);
    const double offset_s = age_s > 0 ? 1 : 0;
    REQUIRE(s.story.heard.size() == 2);
    CHECK(s.story.heard[0].time_s >= before_s - offset_s);
    CHECK(s.story.heard[0].time_s <= monotonic_s() - offset_s);
  }
}

TEST_CASE("A bus that goes down says so of every signal, with the time, before it says why") {
  Setup s;
  s.script.answers = {-ENETDOWN};
  const double before_s = monotonic_s();
  s.steps(2);
  REQUIRE(s.story.heard.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(s.story.heard[i].id.signal == s.bus.signals()[i].signal);
    CHECK(s.story.heard[i].id.boom == 1);
    CHECK(s.story.heard[i].validity == Validity::kBusDown);
    CHECK(s.story.heard[i].time_s >= before_s);
    CHECK(s.story.heard[i].time_s <= monotonic_s());
  }
}

TEST_CASE("A bus that is up again has no value yet: its signals are stale, not down") {
  Setup s;
  s.script.answers = {-ENETDOWN, 0};
  s.script.refusals = {"", ""};
  s.steps(2);
  SignalBoard board;
  board.take({{Signal::kRodCount, 1}, 3, Validity::kValid, 0});
  for (const Reading& reading : s.story.heard) board.take(reading);
  CHECK(board.entry({Signal::kRodCount, 1}).validity == Validity::kBusDown);
  while (s.story.told.back() != "up") s.steps(1);
  for (const Reading& reading : s.story.heard) board.take(reading);
  CHECK(board.entry({Signal::kRodCount, 1}).validity == Validity::kStale);
  CHECK(board.entry({Signal::kRodCount, 1}).refused == 0);
  CHECK(board.entry({Signal::kFeedPressureBar, 1}).validity == Validity::kNeverSeen);
}

TEST_CASE("The kernel passes the messages of the routes; with a tap all data frames") {
  for (const bool tapped : {false, true}) {
    Script script;
    Story story;
    CanBus bus(options(), story, tapped ? &story : nullptr, std::make_unique<ScriptedPort>(script));
    script.frames = {data(9)};
    script.answers = {1};
    bus.step();
    bus.step();
    CHECK(script.opened_with.everything == tapped);
    REQUIRE(script.opened_with.wanted.size() == 2);
    CHECK(script.opened_with.wanted[0].id == 7);
    CHECK(story.told.size() == (tapped ? 2 : 1));
  }
}
