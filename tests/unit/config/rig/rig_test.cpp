#include "rigsound/config/rig.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "config/rig/rig_texts.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;
using namespace rigsound::test;
namespace fs = std::filesystem;

namespace {

/// demo.toml with its further keys switched on, in a folder from which its DBC is found.
std::string demo_with_everything() {
  std::istringstream lines(content(kDemo));
  std::string text, line;
  while (std::getline(lines, line)) {
    const bool further = line.rfind("#: ", 0) == 0;
    if (further && line.find("boom2.feed") != std::string::npos)
      line = "#: boom2.feed_pressure_bar = \"DRILL1.FeedPressure\"";
    text += (further ? line.substr(3) : line) + "\n";
  }
  text = std::regex_replace(text, std::regex(R"(\.\./dbc/rig\.dbc)"), kDbc.string());
  return std::regex_replace(text, std::regex("\n# When the drill"),
                            "\n[[boom]]\nname = \"boom2\"\n# When the drill");
}

}  // namespace

TEST_CASE("the shortest rig has the defaults that demo.toml shows") {
  const config::Rig shortest = loaded(minimal()), demo = config::load_rig(kDemo);
  CHECK(demo.audio.device == shortest.audio.device);
  CHECK(demo.audio.rate == shortest.audio.rate);
  CHECK(demo.audio.block == shortest.audio.block);
  CHECK(demo.audio.periods == shortest.audio.periods);
  CHECK(demo.audio.channels == shortest.audio.channels);
  CHECK(demo.audio.format == shortest.audio.format);
  CHECK(demo.audio.resample == shortest.audio.resample);
  CHECK(demo.engine.seed == shortest.engine.seed);
  CHECK(demo.engine.scene.contact_bar == shortest.engine.scene.contact_bar);
  CHECK(demo.engine.scene.underfeed_bar == shortest.engine.scene.underfeed_bar);
  CHECK(demo.engine.scene.overfeed_bar == shortest.engine.scene.overfeed_bar);
  CHECK(demo.engine.scene.hysteresis_bar == shortest.engine.scene.hysteresis_bar);
  CHECK(demo.engine.scene.crossfade_s == shortest.engine.scene.crossfade_s);
  CHECK(demo.engine.scene.open_burst_s == shortest.engine.scene.open_burst_s);
  CHECK(demo.engine.scene.open_sustain_db == shortest.engine.scene.open_sustain_db);
  CHECK(demo.engine.scene.idle_rpm == shortest.engine.scene.idle_rpm);
  CHECK(demo.engine.mix.drill_db == shortest.engine.mix.drill_db);
  CHECK(demo.engine.mix.tool_db == shortest.engine.mix.tool_db);
  CHECK(demo.engine.mix.diesel_db == shortest.engine.mix.diesel_db);
  CHECK(demo.engine.mix.ceiling_dbfs == shortest.engine.mix.ceiling_dbfs);
  CHECK(demo.safety.fade_s == shortest.safety.fade_s);
  for (int i = 0; i < kSignalCount; ++i)
    CHECK(rule(demo, static_cast<Signal>(i)).action == rule(shortest, static_cast<Signal>(i)).action);
  CHECK(demo.control.socket == shortest.control.socket);
  CHECK(demo.control.group == shortest.control.group);
  CHECK(demo.control.mode == shortest.control.mode);
  CHECK(demo.control.metrics == shortest.control.metrics);
  CHECK(demo.engine.booms[0].name == shortest.engine.booms[0].name);
  CHECK(shortest.sound_set.empty());
}

TEST_CASE("the demo rig reads its bus as its DBC says") {
  const config::Rig demo = config::load_rig(kDemo);
  REQUIRE(demo.can.size() == 1);
  // Every signal of the list has its place: all but one on CAN, that one on Modbus.
  REQUIRE(demo.can[0].routes.size() == kSignalCount - 1);
  const can::SignalRoute& rpm = demo.can[0].routes[0];
  CHECK(rpm.target.signal == Signal::kEngineRpm);
  CHECK(rpm.match.j1939);
  CHECK(rpm.match.id == 0x0CF004FE);
  CHECK(rpm.layout.scale == 0.125);
  const can::SignalRoute& load = demo.can[0].routes[1];
  CHECK(load.match.source == 0);
  CHECK(load.layout.scale == doctest::Approx(0.01));
  CHECK(rule(demo, Signal::kEngineRpm).stale_after_s == doctest::Approx(0.1));         // 3 x 20 ms is less
  CHECK(rule(demo, Signal::kFeedPressureBar).stale_after_s == doctest::Approx(0.15));  // 3 x 50 ms
  CHECK(rule(demo, Signal::kMasterGainDb).stale_after_s == doctest::Approx(1.5));
  CHECK(rule(demo, Signal::kPercussionRateHz).stale_after_s == 0);  // a Modbus client writes when it likes
  CHECK(demo.sound_set.filename() == "soundset");
  CHECK(demo.boom_tools == std::vector<std::string>{"rods"});
  REQUIRE(demo.modbus.size() == 1);
  CHECK(demo.modbus[0].port == 1502);
  CHECK(demo.modbus[0].allow.size() == 2);
}

TEST_CASE("every further key that demo.toml names is one, and together they are a rig") {
  const config::Rig rig = loaded(demo_with_everything());
  REQUIRE(rig.engine.mix.equaliser.size() == 1);
  CHECK(rig.engine.mix.equaliser[0].frequency_hz == 120);
  CHECK(rule(rig, Signal::kEngineRpm).stale_after_s == 0.5);
  CHECK(rule(rig, Signal::kFeedPressureBar).stale_after_s == 0.15);
  REQUIRE(rig.engine.booms.size() == 2);
  const can::SignalRoute& second = rig.can[0].routes.back();
  CHECK(second.target.signal == Signal::kFeedPressureBar);
  CHECK(second.target.boom == 1);
  CHECK(config::signal_label(rig, second.target) == "boom2.feed_pressure_bar");
  CHECK(config::signal_label(rig, {Signal::kFeedPressureBar, 0}) == "feed_pressure_bar");
  REQUIRE(rig.modbus.size() == 2);
  const modbus::ModbusOptions& plc = rig.modbus[1];
  CHECK(plc.role == modbus::Role::kClient);
  CHECK(plc.transport == modbus::Transport::kRtu);
  CHECK(plc.parity == 'E');
  CHECK(plc.routes[0].order == modbus::WordOrder::kCdab);
  CHECK(plc.routes[0].target.boom == 1);
}

TEST_CASE("every key of demo.toml is refused when it is misspelt") {
  const std::string text = demo_with_everything();
  const std::regex key(R"((^|\n|[{,] )([a-z_0-9]+)( = ))");
  int tried = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), key), end; it != end; ++it) {
    std::string wrong = text;
    wrong.insert(static_cast<std::size_t>(it->position(2) + it->length(2)), "q");
    const std::string said = refusal(wrong);
    INFO(it->str(2), ": ", said);
    CHECK(said.rfind(':', 0) == 0);  // FILE:LINE
    CHECK(said.find(it->str(2) + "q") != std::string::npos);
    ++tried;
  }
  CHECK(tried > 70);
}

TEST_CASE("numbers out of range, of another type or not whole are refused with what was expected") {
  CHECK(refusal("[audio]\nrate = 0\n") == ":2: audio.rate: is 0 Hz, expected 32000...192000 Hz");
  CHECK(refusal("[audio]\nrate = 44100.5\n") ==
        ":2: audio.rate: is 44100.5 Hz, expected a whole number, 32000...192000 Hz");
  CHECK(refusal("[audio]\nchannels = nan\n") == ":2: audio.channels: is nan, expected 1...8");
  CHECK(refusal("[mix]\nceiling_dbfs = 3\n") == ":2: mix.ceiling_dbfs: is 3 dBFS, expected -60...0 dBFS");
  CHECK(refusal("[audio]\nresample = 1\n") ==
        ":2: audio.resample: is a whole number, expected true or false");
  CHECK(refusal("audio = 3\n") == ":1: audio: is a whole number, expected a table [audio]");
  CHECK(refusal("[audio]\nblock = 48\n") ==
        ":2: audio.block: is 48 frames, expected 32...8192 frames, a multiple of 32");
  CHECK(refusal("[scene]\ncrossfade_ms = 12000\n") ==
        ":2: scene.crossfade_ms: is 12000 ms, expected 0...10000 ms");
  CHECK(refusal("[[modbus]]\nbaud = 9600\n").find(":2: modbus.baud: goes with transport = \"rtu\" only") ==
        0);
}

TEST_CASE("what the engine's check finds between keys is told with file, line and key") {
  CHECK(refusal("[scene]\ncontact_bar = 70\n") ==
        ":2: scene.contact_bar: is 70 bar, expected less than underfeed_bar, 60 bar");
  CHECK(refusal("[scene]\nhysteresis_bar = 3\nunderfeed_bar = 15\n") ==
        ":1: scene.contact_bar: is 15 bar, expected less than underfeed_bar, 15 bar");
  CHECK(refusal("[audio]\n[scene]\nhysteresis_bar = 3\nunderfeed_bar = 15\n").rfind(":2: scene.contact", 0) ==
        0);  // where its table begins
  CHECK(refusal("[scene]\nunderfeed_bar = 130\n") ==
        ":2: scene.underfeed_bar: is 130 bar, expected at most overfeed_bar, 120 bar");
  CHECK(refusal("[scene]\nunderfeed_bar = 120\n") == "");
  CHECK(refusal("[mix]\nequaliser = [ { q = 2 },\n { frequency_hz = 22000 } ]\n") ==
        ":3: mix.equaliser[1].frequency_hz: is 22000, expected at most 0.45 of the rate, 21600");
  CHECK(refusal("[audio]\nrate = 96000\n[mix]\nequaliser = [ { frequency_hz = 22000 } ]\n") == "");
  CHECK(refusal("[mix]\nequaliser = [ { frequency_hz = 10, q = 20 }, { q = 0.1 } ]\n") == "");
  CHECK(refusal("[safety]\nmax_laeq_db = 80\n") ==
        ":2: safety.max_laeq_db: is 80 dB of an output that is not calibrated, expected mix.db_spl_at_0dbfs "
        "too");
  CHECK(refusal("[mix]\ndb_spl_at_0dbfs = 105\n[safety]\nmax_laeq_db = 80\n") == "");
  CHECK(refusal("[mix]\nlookahead_ms = 1\n") == ":2: mix.lookahead_ms: is 1 ms, expected 0 or 2...20 ms");
  CHECK(refusal("[mix]\nlookahead_ms = 0\n") == "");
}

TEST_CASE("signals go to the boom they name, and to one source only") {
  const std::string two = "[[boom]]\nname = \"left\"\n[[boom]]\nname = \"right\"\n" + minimal();
  const config::Rig rig =
      loaded(two + "left.rattling = \"DRILL1.Rattling\"\nright.rattling = \"DRILL1.Rattling\"\n");
  CHECK(rig.can[0].routes[1].target.boom == 0);
  CHECK(rig.can[0].routes[2].target.boom == 1);
  CHECK(refusal(two + "rigth.rattling = \"DRILL1.Rattling\"\n") ==
        ":10: can.signals.rigth: is no machine signal, did you mean 'right'?");
  CHECK(refusal(two + "right.engine_rpm = \"EEC1.EngSpeed\"\n").find("of the whole rig") !=
        std::string::npos);
  CHECK(refusal(two + "left.rattling = \"DRILL1.Rattling\"\nrattling = \"DRILL1.Rattling\"\n")
            .find("one source") != std::string::npos);
  CHECK(refusal(minimal() + "[[modbus]]\n[modbus.signals]\nengine_rpm = { address = 3 }\n")
            .find("one source") != std::string::npos);
  CHECK(refusal(minimal() + minimal()).find("twice") != std::string::npos);
  CHECK(refusal("[[boom]]\nname = \"a\"\n[[boom]]\nname = \"a\"\n").find("another boom") !=
        std::string::npos);
}

TEST_CASE("booms without a name are numbered, and there are four at most") {
  const config::Rig rig = loaded("[[boom]]\n[[boom]]\nname = \"right\"\n[[boom]]\n" + minimal());
  REQUIRE(rig.engine.booms.size() == 3);
  CHECK(rig.engine.booms[0].name == "boom1");
  CHECK(rig.engine.booms[1].name == "right");
  CHECK(rig.engine.booms[2].name == "boom3");
  std::string booms;
  for (int b = 0; b < kMaxBooms; ++b) booms += "[[boom]]\n";
  CHECK(refusal(booms).empty());
  CHECK(refusal(booms + "[[boom]]\n").find("boom.name: is boom number 5, expected at most 4") !=
        std::string::npos);
  for (const char* name : {"engine_rpm", "a b", ""})
    CHECK(refusal("[[boom]]\nname = \"" + std::string(name) + "\"\n").find("is no boom name") !=
          std::string::npos);
}

TEST_CASE("a UDP input takes what no other bus delivers, or what it is told") {
  const config::Rig all = loaded("[[boom]]\nname = \"a\"\n[[boom]]\nname = \"b\"\n[[udp]]\n");
  REQUIRE(all.udp.size() == 1);
  CHECK(all.udp[0].port == 1503);
  CHECK(all.udp[0].allow.size() == 2);
  int rig_signals = 0, boom_signals = 0;
  for (const SignalInfo& signal : signal_table()) ++(signal.per_boom ? boom_signals : rig_signals);
  CHECK(static_cast<int>(all.udp[0].routes.size()) == rig_signals + 2 * boom_signals);
  CHECK(rule(all, Signal::kFeedPressureBar).stale_after_s == 1);
  const auto& routes = all.udp[0].routes;
  const auto feed = std::find_if(routes.begin(), routes.end(), [](const udp::NameRoute& route) {
    return route.name == "feed_pressure_bar";
  });
  REQUIRE(feed != routes.end());
  CHECK(feed->alias == "a.feed_pressure_bar");
  const config::Rig rest =
      loaded(minimal() + "[[udp]]\naddress = \"0.0.0.0:7000\"\nallow = [\"10.0.0.0/8\"]\n");
  CHECK(std::none_of(rest.udp[0].routes.begin(), rest.udp[0].routes.end(),
                     [](const udp::NameRoute& route) { return route.name == "engine_rpm"; }));
  const config::Rig two = loaded(
      "[[boom]]\nname = \"a\"\n[[boom]]\nname = \"b\"\n[[udp]]\nsignals = [\"b.rattling\"]\n[[udp]]\naddress "
      "= \"[::1]:1504\"\n");
  REQUIRE(two.udp[0].routes.size() == 1);
  CHECK(two.udp[0].routes[0].target.boom == 1);
  CHECK(two.udp[1].host == "::1");
  CHECK(refusal(minimal() + "[[udp]]\nsignals = [\"engine_rpm\"]\n").find("one that another bus delivers") !=
        std::string::npos);
  CHECK(refusal("[[udp]]\nsignals = [\"ratling\"]\n").find("did you mean 'rattling'?") != std::string::npos);
  CHECK(refusal("[[udp]]\naddress = \"localhost\"\n")
            .find(":2: udp.address: \"localhost\" is no address with a port") == 0);
  CHECK(refusal("[[udp]]\nallow = [\"10.0.0.1/8\"]\n").find("is no network") != std::string::npos);
  CHECK(refusal("[[udp]]\n[[udp]]\naddress = \"127.0.0.1:1504\"\n")
            .find("none left that no other bus delivers") != std::string::npos);
}

TEST_CASE("the mode of the control socket is octal, for its user at least, and lets nobody run it") {
  CHECK(loaded("[control]\nmode = \"0666\"\n").control.mode_bits == 0666);
  CHECK(loaded("[control]\nmode = \"600\"\n").control.mode_bits == 0600);
  CHECK(loaded("").control.mode_bits == 0660);
  for (const char* wrong : {"", "0", "0770", "0460", "02660", "0668", "0578", "rw", "-660", " 660", "1666"})
    CHECK(refusal("[control]\nmode = \"" + std::string(wrong) + "\"\n") ==
          ":2: control.mode: is \"" + std::string(wrong) +
              "\", expected \"0600\"...\"0666\", octal: 6 or 4 or 2 or 0 of group and others");
}
