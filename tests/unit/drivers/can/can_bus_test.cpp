// An interface that goes, comes back, overflows and reports errors.
#include "rigsound/can/can_bus.hpp"

#include <doctest/doctest.h>
#include <linux/can/error.h>

#include <cerrno>
#include <deque>

#include "can/can_port.hpp"
#include "rigsound/device_error.hpp"

using namespace rigsound;
using namespace rigsound::can;

namespace {

struct Script {
  std::deque<int> answers;           // of receive(): frames, or a negative errno value
  std::deque<std::string> refusals;  // of open(): a reason, or empty for success
  std::vector<Frame> frames;         // what the next receive() delivers
  std::uint64_t dropped = 0;
  std::vector<int> waits;
};

class ScriptedLink : public CanLink {
 public:
  explicit ScriptedLink(Script& script) : script_(script) {}
  int receive(Arrival* out, std::size_t, int) override {
    const int answer = script_.answers.front();
    script_.answers.pop_front();
    for (int i = 0; i < answer; ++i) out[i].frame = script_.frames[static_cast<std::size_t>(i)];
    return answer;
  }
  std::uint64_t dropped() const override { return script_.dropped; }

 private:
  Script& script_;
};

class ScriptedPort : public CanPort {
 public:
  explicit ScriptedPort(Script& script) : script_(script) {}
  std::unique_ptr<CanLink> open(const CanBusOptions&) override {
    const std::string refusal = script_.refusals.empty() ? "" : script_.refusals.front();
    if (!script_.refusals.empty()) script_.refusals.pop_front();
    if (!refusal.empty()) throw DeviceError(refusal);
    return std::make_unique<ScriptedLink>(script_);
  }
  void wait_for_change(int timeout_ms) override { script_.waits.push_back(timeout_ms); }

 private:
  Script& script_;
};

struct Story : CanListener {
  void frames(const Arrival* first, std::size_t count) override {
    told.push_back("frames " + std::to_string(count) + " from " + std::to_string(first->frame.id));
  }
  void up() override { told.emplace_back("up"); }
  void down(const std::string& why) override { told.push_back("down " + why.substr(0, 20)); }
  void notice(const std::string& text) override { told.push_back("notice " + text); }
  std::vector<std::string> told;
};

struct Setup {
  Setup() {
    CanBusOptions options;
    options.interface = "can0";
    bus = std::make_unique<CanBus>(options, story, std::make_unique<ScriptedPort>(script));
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) bus->step();
  }
  Script script;
  Story story;
  std::unique_ptr<CanBus> bus;
};

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
    CHECK(s.bus->counters().lost == 1);
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
  const CanCounters c = s.bus->counters();
  CHECK(c.frames == 3);
  CHECK(c.error_frames == 2);
  CHECK(c.dropped == 22);  // 11 on each of two sockets
}

TEST_CASE("A controller that reports its trouble again and again is told once a second at most") {
  Setup s;
  s.script.frames.assign(200, error(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE));
  s.script.answers = {200, 200, 200};
  s.steps(4);
  CHECK(s.story.told.size() == 2);
  CHECK(s.bus->counters().error_frames == 600);
}

TEST_CASE("Bus-off takes the bus down once, with the mend, until the controller restarts") {
  Setup s;
  s.script.answers = {1, 1, 1};
  s.script.frames = {error(CAN_ERR_BUSOFF)};
  s.steps(3);
  s.script.frames = {error(CAN_ERR_RESTARTED)};
  s.steps(1);
  CHECK(s.story.told == std::vector<std::string>{"up", "down can0: the controller", "up"});
}
