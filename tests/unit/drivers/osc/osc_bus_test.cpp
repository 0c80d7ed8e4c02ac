// Packets of every shape, and a real port on loopback.
#include "osc/osc_bus.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <mutex>
#include <random>
#include <string>
#include <vector>

#include "drivers/modbus/bus_harness.hpp"
#include "rigsound/machine/signal_board.hpp"
#include "rigsound/monotonic_time.hpp"
#include "rigsound/udp/udp_sender.hpp"

using namespace rigsound;
using namespace rigsound::osc;
using modbus::await;
using modbus::count;
using modbus::Running;
using modbus::Told;

namespace {

/// Ended by at least one zero, to a multiple of four.
std::string padded(std::string text) {
  text += '\0';
  while (text.size() % 4 != 0) text += '\0';
  return text;
}

std::string big_endian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xff);
  return text;
}

std::string message(const std::string& path, const std::string& type, const std::string& argument) {
  return padded(path) + padded("," + type) + argument;
}

std::string of_float(const std::string& path, float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return message(path, "f", big_endian(bits, 4));
}

std::string bundle(std::uint64_t tag, const std::vector<std::string>& elements) {
  std::string text = padded("#bundle") + big_endian(tag, 8);
  for (const std::string& element : elements) text += big_endian(element.size(), 4) + element;
  return text;
}

/// A time tag so far from now.
std::uint64_t tag_in(double seconds) {
  const double now_s =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  return static_cast<std::uint64_t>(std::llround((now_s + seconds + 2208988800.0) * 65536)) << 16;
}

/// "/a 1; /b open; /c nil", or "! why not".
std::string read(const std::string& bytes) {
  std::string problem, told;
  const auto messages = read_packet(bytes, problem);
  if (!messages) return "! " + problem;
  for (const Message& m : *messages) {
    told += (told.empty() ? "" : "; ") + m.path + " ";
    const auto* const number = std::get_if<double>(&m.said);
    const auto* const word = std::get_if<std::string>(&m.said);
    told += number != nullptr ? number_text(*number) : word != nullptr ? *word : "nil";
  }
  return told;
}

OscOptions options() {
  OscOptions o;
  o.address = "127.0.0.1:0";
  o.host = "127.0.0.1";
  o.routes = {{{Signal::kEngineRpm, 0}, "engine_rpm", ""},
              {{Signal::kFeedPressureBar, 0}, "feed_pressure_bar", "boom1.feed_pressure_bar"},
              {{Signal::kFeedPressureBar, 1}, "boom2.feed_pressure_bar", ""},
              {{Signal::kRattling, 1}, "boom2.rattling", ""}};
  o.booms = {"boom1", "boom2"};
  return o;
}

struct Controls : ControlListener {
  void control(int boom, const ControlInfo& control, double value) override {
    const std::lock_guard<std::mutex> lock(mutex);
    told.push_back(std::to_string(boom) + " " + std::string(control.name) + " " + number_text(value));
  }
  void mute(bool on) override {
    const std::lock_guard<std::mutex> lock(mutex);
    told.push_back(on ? "mute" : "unmute");
  }
  std::vector<std::string> all() {
    const std::lock_guard<std::mutex> lock(mutex);
    return told;
  }
  std::mutex mutex;
  std::vector<std::string> told;
};

struct Listening {
  Listening() : bus(options(), told, controls) {
    bus.step();
    REQUIRE(bus.port() != 0);
    sender = std::make_unique<udp::UdpSender>("127.0.0.1:" + std::to_string(bus.port()));
    running = std::make_unique<Running>(bus);
  }
  void send(const std::string& bytes) const { REQUIRE(sender->send(bytes)); }

  Told told;
  Controls controls;
  OscBus bus;
  std::unique_ptr<udp::UdpSender> sender;
  std::unique_ptr<Running> running;
};

}  // namespace

TEST_CASE("A message says a number, a truth, a word or nothing, in any type that OSC has for it") {
  CHECK(read(of_float("/rigsound/engine_rpm", 1500.5F)) == "/rigsound/engine_rpm 1500.5");
  CHECK(read(message("/a", "i", big_endian(7, 4))) == "/a 7");
  CHECK(read(message("/a", "i", big_endian(0xfffffffe, 4))) == "/a -2");
  CHECK(read(message("/a", "h", big_endian(1ULL << 40, 8))) == "/a 1.099511628e+12");
  CHECK(read(message("/a", "d", big_endian(0x4059000000000000, 8))) == "/a 100");
  CHECK(read(message("/a", "T", "")) == "/a 1");
  CHECK(read(message("/a", "F", "")) == "/a 0");
  CHECK(read(message("/a", "N", "")) == "/a nil");
  CHECK(read(message("/a", "s", padded("open"))) == "/a open");
  CHECK(read(message("/a", "S", padded("closed"))) == "/a closed");
}

TEST_CASE("A bundle holds messages and bundles, with the time of the innermost") {
  CHECK(read(bundle(1, {})) == "");
  CHECK(read(bundle(1, {of_float("/a", 1), bundle(1, {of_float("/b", 2)}), of_float("/c", 3)})) ==
        "/a 1; /b 2; /c 3");
  std::string problem;
  const auto messages = read_packet(
      bundle(1, {of_float("/a", 1), bundle(2208988800ULL << 32 | 0x80000000, {of_float("/b", 2)})}), problem);
  REQUIRE(messages);
  CHECK((*messages)[0].due_s == 0);
  CHECK((*messages)[1].due_s == 0.5);
}

TEST_CASE("A packet counts whole or not at all") {
  const std::string good = of_float("/a", 1);
  for (const std::string& text : {std::string(),
                                  std::string("x"),
                                  std::string(4, '\0'),
                                  padded("/a"),
                                  message("/a", "", ""),
                                  message("/a", "f", ""),
                                  message("/a", "ff", std::string(8, '\0')),
                                  message("/a", "b", big_endian(0xffffffff, 4)),
                                  message("/a", "b", big_endian(4, 4) + "1234"),
                                  message("/a", "x", ""),
                                  message("a", "i", big_endian(1, 4)),
                                  good.substr(0, good.size() - 1),
                                  good + "x",
                                  std::string("{\"engine_rpm\": 1}"),
                                  padded("#bundle"),
                                  bundle(1, {good}) + "1234",
                                  bundle(1, {good.substr(0, 8)}),
                                  bundle(1, {good, "/b"}),
                                  padded("#bundle") + big_endian(1, 8) + big_endian(0, 4),
                                  padded("#bundle") + big_endian(1, 8) + big_endian(1000, 4) + good}) {
    CAPTURE(text);
    CHECK(read(text).rfind("! ", 0) == 0);
  }
  std::string deepest = good;
  for (int i = 0; i < 8; ++i) deepest = bundle(1, {deepest});
  CHECK(read(deepest) == "/a 1");
  CHECK(read(bundle(1, {deepest})) == "! bundles in bundles");
  std::string deep = good;
  for (int i = 0; i < 200; ++i) deep = bundle(1, {deep});
  CHECK(read(deep) == "! bundles in bundles");
}

TEST_CASE("Garbage, and good packets damaged anywhere, are read without harm") {
  std::mt19937 random(1);
  const AddressSpace space(options());
  const std::string whole = bundle(
      tag_in(1), {of_float("/rigsound/*/decay_factor", 2), message("/a", "sifTNhd", std::string(64, 'x'))});
  for (int i = 0; i < 20000; ++i) {
    std::string text = i % 2 == 0 ? whole : std::string(random() % 64, '/');
    for (std::size_t k = 0, changes = 1 + random() % 4; k < changes && !text.empty(); ++k)
      text[random() % text.size()] = static_cast<char>(random());
    text.resize(text.size() - random() % (text.size() + 1) / 3);
    std::string problem;
    const auto messages = read_packet(text, problem);
    if (!messages) REQUIRE_FALSE(problem.empty());
    if (messages)
      for (const Message& m : *messages) space.find(m.path);
  }
}

TEST_CASE("What is written is read again") {
  CHECK(read(write_bundle({{"/rigsound/muted", 1},
                           {"/rigsound/meters/peak_db", -12.5F},
                           {"/rigsound/left/situation", std::string("overfeed")}})) ==
        "/rigsound/muted 1; /rigsound/meters/peak_db -12.5; /rigsound/left/situation overfeed");
}

TEST_CASE(
    "Addresses are those of the rig's signals, the controls of its booms, and mute; patterns name several") {
  const AddressSpace space(options());
  const auto count_of = [&](const std::string& path) { return space.find(path).size(); };
  CHECK(count_of("/rigsound/engine_rpm") == 1);
  CHECK(count_of("/rigsound/boom1/feed_pressure_bar") == 1);
  CHECK(space.find("/rigsound/feed_pressure_bar")[0].signal.boom == 0);
  CHECK(space.find("/rigsound/boom2/feed_pressure_bar")[0].signal.boom == 1);
  CHECK(count_of("/rigsound/rattling") == 0);  // another bus delivers it
  CHECK(count_of("/rigsound/boom3/feed_pressure_bar") == 0);
  CHECK(count_of("/rigsound/decay_factor") == 2);
  CHECK(count_of("/rigsound/boom2/decay_factor") == 1);
  CHECK(count_of("/rigsound/boom?/decay_factor") == 2);
  CHECK(count_of("/rigsound/{boom2,boom7}/decay_factor") == 1);
  CHECK(count_of("/rigsound/boom*/feed_pressure_bar") == 2);
  CHECK(count_of("/rigsound/mute") == 1);
  CHECK(count_of("/engine_rpm") == 0);
  CHECK(count_of("") == 0);
  CHECK(count_of("/*o*o*o*o*o*o*o*o*o*o*o*o*x") == 0);  // at once
  for (const ControlInfo& control : control_table())
    CHECK(count_of("/rigsound/boom1/" + std::string(control.name)) == 1);
}

TEST_CASE("Signals are readings, judged by the board as those of every bus") {
  Listening l;
  l.send(of_float("/rigsound/engine_rpm", 1500));
  l.send(bundle(1, {of_float("/rigsound/boom2/feed_pressure_bar", 90),
                    message("/rigsound/boom2/rattling", "s", padded("open"))}));
  await([&] { return l.told.of(Signal::kRattling).value == 2; });
  CHECK(l.told.of(Signal::kEngineRpm).value == 1500);
  CHECK(l.told.of(Signal::kEngineRpm).time_s > 0);
  CHECK(l.told.of(Signal::kFeedPressureBar).value == 90);
  CHECK(l.told.of(Signal::kFeedPressureBar).id.boom == 1);
  l.send(message("/rigsound/boom2/rattling", "s", padded("opn")));
  await([&] { return std::isnan(l.told.of(Signal::kRattling).value); });
  SignalBoard board;
  CHECK(board.take(l.told.of(Signal::kRattling)) == Validity::kOutOfRange);
  l.send(message("/rigsound/engine_rpm", "N", ""));
  await([&] { return l.told.of(Signal::kEngineRpm).validity == Validity::kNotAvailable; });
}

TEST_CASE("Controls and mute go to who sets them, within their range; what cannot be is counted") {
  Listening l;
  l.send(of_float("/rigsound/boom2/decay_factor", 2));
  l.send(of_float("/rigsound/mean_frequency_hz", 42));
  l.send(message("/rigsound/mute", "T", ""));
  l.send(message("/rigsound/mute", "i", big_endian(0, 4)));
  l.send(of_float("/rigsound/boom2/decay_factor", 11));
  l.send(of_float("/rigsound/boom2/decay_factor", NAN));
  l.send(message("/rigsound/decay_factor", "s", padded("much")));
  l.send(of_float("/rigsound/mute", 0.5F));
  l.send("no OSC");
  l.send(of_float("/rigsound/volume", 1));
  await([&] { return count(l.bus, "frames_seen") == 10; });
  CHECK(l.controls.all() == std::vector<std::string>{"1 decay_factor 2", "0 mean_frequency_hz 42",
                                                     "1 mean_frequency_hz 42", "mute", "unmute"});
  CHECK(count(l.bus, "frames_bad") == 5);
  CHECK(count(l.bus, "frames_used") == 4);
  await([&] { return l.told.notices() == 3; });  // broken, impossible, unknown
}

TEST_CASE("A bundle for later waits for its time, one of a wrong clock does not") {
  Listening l;
  l.send(bundle(tag_in(4), {of_float("/rigsound/engine_rpm", 900)}));
  l.send(bundle(tag_in(-100), {of_float("/rigsound/boom2/feed_pressure_bar", 50)}));
  await([&] { return l.told.of(Signal::kFeedPressureBar).value == 50; });
  const double before_s = l.told.of(Signal::kFeedPressureBar).time_s;
  await([&] { return l.told.of(Signal::kEngineRpm).value == 900; });
  CHECK(l.told.of(Signal::kEngineRpm).time_s > before_s);
  l.send(bundle(tag_in(3600), {of_float("/rigsound/engine_rpm", 1000)}));
  await([&] { return l.told.of(Signal::kEngineRpm).value == 1000; });
  CHECK(l.told.notices() == 1);
}

TEST_CASE("A message that waits neither holds up the rounds nor waits for the end of one") {
  Told told;
  Controls controls;
  OscBus bus(options(), told, controls);
  bus.step();
  REQUIRE(bus.port() != 0);
  const udp::UdpSender sender("127.0.0.1:" + std::to_string(bus.port()));
  REQUIRE(sender.send(bundle(tag_in(2), {of_float("/rigsound/engine_rpm", 900)})));
  int rounds = 0;
  for (; told.of(Signal::kEngineRpm).value != 900; ++rounds) bus.step();
  CHECK(rounds > 3);  // ten of a fifth of a second

  // One of many in its time is enough: a machine that is busy may be late for the others.
  bool in_time = false;
  for (int i = 0; i < 50 && !in_time; ++i) {
    const double due_s = monotonic_s() + 0.02;
    REQUIRE(sender.send(bundle(tag_in(0.02), {of_float("/rigsound/engine_rpm", static_cast<float>(i))})));
    while (told.of(Signal::kEngineRpm).value != i) bus.step();
    in_time = told.of(Signal::kEngineRpm).time_s < due_s + 0.03;
  }
  CHECK(in_time);
}

TEST_CASE("So many messages wait for later, and no more") {
  Listening l;
  const std::string full = bundle(tag_in(9), std::vector<std::string>(600, message("/a", "T", "")));
  l.send(full);
  l.send(full);
  await([&] { return count(l.bus, "frames_bad") == 176; });
  CHECK(l.told.notices() == 1);
}
