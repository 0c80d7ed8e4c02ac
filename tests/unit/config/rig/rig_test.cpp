#include "rigsound/config/rig.hpp"

#include <doctest/doctest.h>

#include <regex>
#include <sstream>

#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::test;
namespace fs = std::filesystem;

namespace {

const fs::path kDemo = fs::path(RIGSOUND_CONFIG) / "rigs/demo.toml";
const fs::path kDbc = fs::path(RIGSOUND_CONFIG) / "dbc/rig.dbc";

std::string minimal() {
  return "[[can]]\ninterface = \"can0\"\ndbc = \"" + kDbc.string() +
         "\"\n[can.signals]\nengine_rpm = \"EEC1.EngSpeed\"\n";
}

config::Rig loaded(const std::string& text) {
  TemporaryFolder folder;
  return config::load_rig(folder.write("rig.toml", text));
}

std::string refusal(const std::string& text) {
  TemporaryFolder folder;
  const fs::path file = folder.write("rig.toml", text);
  const std::string said = complaint([&] { config::load_rig(file); });
  return said.rfind(file.string(), 0) == 0 ? said.substr(file.string().size()) : said;
}

const SafetyRule& rule(const config::Rig& rig, Signal s) {
  return rig.safety.rule[static_cast<std::size_t>(s)];
}

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
  CHECK(demo.boom_tools == std::vector<std::string>{"steel"});
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
    CHECK(said.rfind(":", 0) == 0);  // FILE:LINE
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
  CHECK(refusal("[scene]\nunderfeed_bar = 130\n") ==
        ":2: scene.underfeed_bar: is 130 bar, expected at most overfeed_bar, 120 bar");
  CHECK(refusal("[scene]\nunderfeed_bar = 120\n") == "");
  CHECK(refusal("[mix]\nequaliser = [ { q = 2 },\n { frequency_hz = 22000 } ]\n") ==
        ":3: mix.equaliser[1].frequency_hz: is 22000, expected at most 0.45 of the rate, 21600");
  CHECK(refusal("[audio]\nrate = 96000\n[mix]\nequaliser = [ { frequency_hz = 22000 } ]\n") == "");
  CHECK(refusal("[mix]\nequaliser = [ { frequency_hz = 10, q = 20 }, { q = 0.1 } ]\n") == "");
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

TEST_CASE("Modbus registers are checked") {
  const auto said = [](const std::string& entry) {
    return refusal("[[modbus]]\n[modbus.signals]\nrock = " + entry + "\n");
  };
  CHECK(said("{ table = \"holding\" }") ==
        ":3: modbus.signals.rock.address: is missing, expected a register or bit counted from 0");
  CHECK(said("{ address = 65536 }") == ":3: modbus.signals.rock.address: is 65536, expected 0...65535");
  CHECK(said("{ address = 65535, type = \"float32\" }").find("two registers") != std::string::npos);
  CHECK(said("{ address = 0, table = \"coil\", type = \"int16\" }").find("does not go with a bit") !=
        std::string::npos);
  CHECK(said("{ address = 0, scale = 0 }").find("is 0, expected any other number") != std::string::npos);
  CHECK(refusal("[[modbus]]\nallow = [\"10.0.0.1/8\"]\n").find("is no network") != std::string::npos);
  CHECK(refusal("[[modbus]]\nunit = 250\n").find("is no unit") != std::string::npos);
  CHECK(refusal("[[modbus]]\ntransport = \"rtu\"\n").find("modbus.address: is missing") != std::string::npos);
}

TEST_CASE("a DBC signal that cannot be read is refused where the DBC defines it") {
  TemporaryFolder folder;
  const fs::path rig = folder.write(
      "rig.toml", "[[can]]\ninterface = \"can0\"\ndbc = \"a.dbc\"\n[can.signals]\nengine_rpm = \"A.S\"\n");
  const auto said = [&](const std::string& message, const std::string& signal) {
    folder.write("a.dbc", "BO_ " + message + " A: 8 X\n SG_ S : " + signal + " (1,0) [0|0] \"\" X\n");
    return complaint([&] { config::load_rig(rig); });
  };
  CHECK(said("1", "0|16@1+") == "");
  CHECK(said("1", "57|8@1+").find("a.dbc:2: A.S: does not fit into the 8 bytes of its frame") !=
        std::string::npos);
  CHECK(said("1", "48|17@0+").find("does not fit") != std::string::npos);
  CHECK(said("1", "0|65@1+").find("longer than 64 bits") != std::string::npos);
  CHECK(said("4096", "0|8@1+").find("bit 31") != std::string::npos);
}
