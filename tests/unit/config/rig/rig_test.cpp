#include "rigsound/config/rig.hpp"

#include <doctest/doctest.h>

#include <algorithm>
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

TEST_CASE("Modbus registers are checked") {
  const auto said = [](const std::string& entry) {
    return refusal("[[modbus]]\n[modbus.signals]\nrock = " + entry + "\n");
  };
  CHECK(said("{ table = \"holding\" }") ==
        ":3: modbus.signals.rock.address: is missing, expected a register or bit counted from 0");
  CHECK(said("{ address = 65536 }") == ":3: modbus.signals.rock.address: is 65536, expected 0...65535");
  CHECK(said("{ address = 65535, type = \"float32\" }").find("expected at most 65534") != std::string::npos);
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

namespace {

/// A rig whose bus has these signals of a DBC, as `name : bits... unit`.
config::Rig with_signals(const std::string& dbc_signals, const std::string& routes) {
  TemporaryFolder folder;
  folder.write("a.dbc", "BO_ 256 M: 8 A\n" + dbc_signals);
  return config::load_rig(
      folder.write("rig.toml", "[[can]]\ninterface = \"can0\"\ndbc = \"a.dbc\"\n[can.signals]\n" + routes));
}

std::string doubt(const std::string& dbc_signals, const std::string& routes) {
  const config::Rig rig = with_signals(dbc_signals, routes);
  CHECK(rig.doubts.size() <= 1);
  if (rig.doubts.empty()) return {};
  const std::size_t key = rig.doubts.front().find(": can.signals.");
  REQUIRE(key != std::string::npos);
  return rig.doubts.front().substr(key + 14);
}

}  // namespace

TEST_CASE("units and ranges of a DBC that do not fit the signal are told, with the likely scale") {
  CHECK(doubt(" SG_ Feed : 0|16@1+ (1,0) [0|40000] \"kPa\" A\n", "feed_pressure_bar = \"M.Feed\"\n") ==
        "feed_pressure_bar: M.Feed is in kPa, feed_pressure_bar in bar: scale = 0.01?");
  CHECK(doubt(" SG_ Feed : 0|16@1+ (1,0) [0|30000] \"kPa\" A\n",
              "feed_pressure_bar = { signal = \"M.Feed\", scale = 0.01 }\n") == "");
  CHECK(doubt(" SG_ Feed : 0|16@1+ (1,0) [0|300] \"MPa\" A\n",
              "feed_pressure_bar = { signal = \"M.Feed\", scale = 0.1 }\n") ==
        "feed_pressure_bar: M.Feed is in MPa, feed_pressure_bar in bar, the rig's scale is 0.1: scale = 10?");
  CHECK(
      doubt(" SG_ Feed : 0|16@1+ (0.01,0) [0|400] \"bar\" A\n", "feed_pressure_bar = \"M.Feed\"\n") ==
      "feed_pressure_bar: M.Feed goes from 0 to 400 bar, feed_pressure_bar from 0 to 300 bar: what is above "
      "counts as 300");
  CHECK(doubt(" SG_ Rods : 0|8@1+ (1,0) [0|100] \"%\" A\n", "rod_count = \"M.Rods\"\n") ==
        "rod_count: M.Rods is in %, rod_count a whole number: another signal?");
  CHECK(doubt(" SG_ Load : 0|8@1+ (1,0) [0|100] \"\" A\n", "engine_load = \"M.Load\"\n") ==
        "engine_load: M.Load goes from 0 to 100, engine_load from 0 to 1: scale = 0.01?");
  CHECK(doubt(" SG_ Speed : 0|16@1+ (0.125,0) [0|8191.875] \"rpm\" A\n", "engine_rpm = \"M.Speed\"\n") == "");
  CHECK(doubt(" SG_ Rate : 0|16@1+ (1,0) [0|3000] \"1/min\" A\n", "percussion_rate_hz = \"M.Rate\"\n") ==
        "percussion_rate_hz: M.Rate is in 1/min, percussion_rate_hz in Hz: scale = 0.01666666667?");
}

TEST_CASE("two signals that stand in each other's place are named") {
  const std::string both =
      " SG_ Speed : 0|16@1+ (0.125,0) [0|0] \"rpm\" A\n SG_ Feed : 16|16@1+ (0.01,0) [0|0] \"bar\" A\n";
  const config::Rig rig = with_signals(both, "engine_rpm = \"M.Feed\"\nfeed_pressure_bar = \"M.Speed\"\n");
  REQUIRE(rig.doubts.size() == 2);
  CHECK(rig.doubts[0].find("M.Feed is in bar, engine_rpm in r/min: swapped with feed_pressure_bar?") !=
        std::string::npos);
  CHECK(rig.doubts[1].find("swapped with engine_rpm?") != std::string::npos);
  CHECK(with_signals(both, "engine_rpm = \"M.Speed\"\nfeed_pressure_bar = \"M.Feed\"\n").doubts.empty());
}

TEST_CASE("signals that are swapped are told by their ranges, too") {
  const std::string both =
      " SG_ A : 0|16@1+ (1,0) [0|4000] \"\" A\n SG_ B : 16|16@1+ (0.01,0) [0|250] \"\" A\n";
  const config::Rig rig = with_signals(both, "engine_rpm = \"M.B\"\nfeed_pressure_bar = \"M.A\"\n");
  REQUIRE(rig.doubts.size() == 1);
  CHECK(rig.doubts[0].find("swapped with engine_rpm?") != std::string::npos);
}

TEST_CASE("a share in percent is understood by its unit, unless the rig gives a scale") {
  const std::string load = " SG_ Load : 0|8@1+ (0.5,0) [0|100] \"%\" A\n";
  const config::Rig by_unit = with_signals(load, "engine_load = \"M.Load\"\n");
  CHECK(by_unit.can[0].routes[0].layout.scale == doctest::Approx(0.005));
  CHECK(by_unit.doubts.empty());
  const config::Rig by_scale = with_signals(load, "engine_load = { signal = \"M.Load\", scale = 0.01 }\n");
  CHECK(by_scale.can[0].routes[0].layout.scale == doctest::Approx(0.005));
}

TEST_CASE("the demo rig leaves nothing to doubt") { CHECK(config::load_rig(kDemo).doubts.empty()); }

TEST_CASE("raw values with a text are what the text says") {
  const std::string map = " SG_ P : 0|2@1+ (1,0) [0|3] \"\" A\n";
  const auto codes = [&](const std::string& texts) {
    const config::Rig rig = with_signals(map + "VAL_ 256 P " + texts + " ;\n", "percussion = \"M.P\"\n");
    std::string text;
    for (const can::RawCode& code : rig.can[0].routes[0].layout.codes)
      text += std::to_string(code.raw) + " " + std::string(name(code.meaning)) + "; ";
    return text;
  };
  CHECK(codes("0 \"off\" 1 \"on\" 2 \"Error\" 3 \"Not available (SNA)\"") ==
        "0 valid; 1 valid; 2 error_value; 3 not_available; ");
  CHECK(codes("0 \"No error\" 1 \"Sensor fault\" 2 \"reserved\" 3 \"N/A\"") ==
        "0 valid; 1 error_value; 2 error_value; 3 not_available; ");
}

TEST_CASE("several DBC files a bus; a name in two of them is refused with both places") {
  TemporaryFolder folder;
  const std::string a = "BO_ 256 M: 8 A\n SG_ Speed : 0|16@1+ (1,0) [0|0] \"rpm\" A\n";
  folder.write("a.dbc", a);
  folder.write("b.dbc", "\nBO_ 257 N: 8 A\n SG_ Feed : 0|16@1+ (1,0) [0|0] \"bar\" A\n");
  folder.write("c.dbc", "\n\nBO_ 256 M: 8 A\n SG_ Speed : 0|16@1+ (2,0) [0|0] \"rpm\" A\n");
  folder.write("d.dbc", "\n\n" + a);
  const auto rig = [&](const std::string& list, const std::string& signals) {
    return folder.write("rig.toml",
                        "[[can]]\ninterface = \"can0\"\ndbc = " + list + "\n[can.signals]\n" + signals);
  };
  const std::string both = "engine_rpm = \"M.Speed\"\nfeed_pressure_bar = \"N.Feed\"\n";
  CHECK(config::load_rig(rig("[\"a.dbc\", \"b.dbc\"]", both)).can[0].routes.size() == 2);
  const std::string said =
      complaint([&] { config::load_rig(rig("[\"a.dbc\", \"b.dbc\", \"c.dbc\"]", both)); });
  CHECK(said.find("'M.Speed' is in ") != std::string::npos);
  CHECK(said.find("a.dbc:2 and, otherwise, in ") != std::string::npos);
  CHECK(said.find("c.dbc:4, expected it in one of them") != std::string::npos);
  CHECK(config::load_rig(rig("[\"a.dbc\", \"b.dbc\", \"d.dbc\"]", both)).can[0].routes.size() == 2);
  CHECK(complaint([&] { config::load_rig(rig("[]", both)); }).find("can.dbc: is empty") != std::string::npos);
}

TEST_CASE("a J1939 message that needs the transport protocol is refused as such") {
  TemporaryFolder folder;
  folder.write("a.dbc",
               "BO_ 2566852862 M: 22 A\n SG_ Feed : 0|16@1+ (1,0) [0|0] \"bar\" A\n"
               "BA_DEF_ BO_ \"VFrameFormat\" ENUM \"S\",\"E\",\"r\",\"J1939PG\";\n"
               "BA_DEF_DEF_ \"VFrameFormat\" \"J1939PG\";\n");
  const auto rig = folder.write("rig.toml",
                                "[[can]]\ninterface = \"can0\"\ndbc = \"a.dbc\"\n[can.signals]\n"
                                "feed_pressure_bar = \"M.Feed\"\n");
  CHECK(complaint([&] { config::load_rig(rig); }).find("transport protocol (PGN 60416 and 60160)") !=
        std::string::npos);
}

namespace {

std::string section(const std::string& keys, const std::string& signals) {
  return "[[modbus]]\n" + keys + "[modbus.signals]\n" + signals;
}
const char* const kFeedAt0 = "feed_pressure_bar = { address = 0 }\n";
const char* const kRodsAt0 = "rod_count = { address = 0 }\n";

modbus::RegisterRoute route_of(const std::string& signal) {
  return loaded(section("role = \"client\"\n", signal + "\n")).modbus.at(0).routes.at(0);
}

}  // namespace

TEST_CASE("bits, masks and tables of values of a Modbus register") {
  CHECK(route_of("percussion = { address = 0, bit = 3 }").mask == 8);
  CHECK(route_of("rod_count = { address = 0, mask = 0xF00 }").mask == 0xF00);
  CHECK(route_of("rod_count = { address = 0, type = \"uint32\", mask = 4294967295 }").mask == 0xFFFFFFFF);
  const auto rattling =
      route_of("rattling = { address = 0, values = { 0 = \"none\", 3 = \"open\", 7 = 1 } }");
  REQUIRE(rattling.values.size() == 3);
  CHECK((rattling.values[1].raw == 3 && rattling.values[1].value == 2));
  CHECK((rattling.values[2].raw == 7 && rattling.values[2].value == 1));
  const auto refused = [](const std::string& signal) { return refusal(section("", signal + "\n")); };
  CHECK(refused("percussion = { address = 0, bit = 3, mask = 8 }").find("expected one of them") !=
        std::string::npos);
  CHECK(refused("percussion = { address = 0, bit = 32 }").find("0...31") != std::string::npos);
  CHECK(refused("percussion = { table = \"coil\", address = 0, bit = 3 }").find("does not go with a bit") !=
        std::string::npos);
  CHECK(refused("feed_pressure_bar = { address = 0, type = \"float32\", mask = 3 }")
            .find("does not go with a float") != std::string::npos);
  CHECK(refused("rattling = { address = 0, values = { 0 = \"nun\" } }")
            .find("expected one of none,closed,open") != std::string::npos);
  CHECK(refused("rattling = { address = 0, values = { a = \"none\" } }").find("is no raw value") !=
        std::string::npos);
  CHECK(refused("rattling = { address = 0, values = { 0 = 9 } }").find("0...2") != std::string::npos);
  CHECK(
      refused("rattling = { address = 0, scale = 2, values = { 0 = 1 } }").find("does not go with values") !=
      std::string::npos);
  CHECK(refused("feed_pressure_bar = { address = 65533, type = \"float64\" }").find("at most 65532") !=
        std::string::npos);
}

TEST_CASE("what cannot share a line or a port is refused, what can becomes one line") {
  const auto both = [](const std::string& a, const std::string& b) {
    return refusal(section(a, kFeedAt0) + section(b, kRodsAt0));
  };
  const std::string server = "address = \"127.0.0.1:1502\"\n", client = "role = \"client\"\n" + server;
  CHECK(both(server, server + "unit = 2\n").find("is a port that two servers listen at") !=
        std::string::npos);
  CHECK(
      both(server, "address = \"0.0.0.0:1502\"\nallow = [\"10.0.0.0/8\"]\n").find("two servers listen at") !=
      std::string::npos);
  CHECK(both(server, client) == "");  // one asks what the other serves
  CHECK(both(client + "unit = 1\n", client + "unit = 2\n") == "");
  CHECK(both(client, client + "transport = \"rtu_tcp\"\nunit = 2\n").find("expected the same transport") !=
        std::string::npos);
  const std::string line = "transport = \"rtu\"\naddress = \"/dev/ttyS77\"\n";
  CHECK(both("role = \"client\"\n" + line, "role = \"client\"\nunit = 2\n" + line) == "");
  CHECK(both("role = \"client\"\n" + line, "role = \"client\"\nbaud = 9600\n" + line)
            .find("the same transport, baud") != std::string::npos);
  CHECK(both(line, "role = \"client\"\n" + line).find("on a line with a server") != std::string::npos);
  const config::Rig rig =
      loaded(section(client + "unit = 1\n", kFeedAt0) + section(client + "unit = 2\n", kRodsAt0));
  CHECK(rig.modbus.size() == 2);
}

TEST_CASE("units, manuals' numbers and servers that hear nobody") {
  CHECK(refusal(section("unit = 0\n", kFeedAt0)) == "");
  CHECK(refusal(section("transport = \"rtu\"\naddress = \"/dev/ttyS77\"\nunit = 0\n", kFeedAt0))
            .find("0 is a broadcast on RTU") != std::string::npos);
  CHECK(refusal(section("unit = 248\n", kFeedAt0)).find("0 or 255 on TCP") != std::string::npos);
  const auto doubts = [](const std::string& keys, const std::string& signals) {
    const config::Rig rig = loaded(section(keys, signals));
    return rig.doubts.empty() ? std::string() : rig.doubts.front();
  };
  CHECK(doubts("", "feed_pressure_bar = { address = 40001 }\n")
            .find("address 40001 counts from 0, so it is holding 40001 = 80002: address = 0?") !=
        std::string::npos);
  CHECK(doubts("", "feed_pressure_bar = { table = \"input\", address = 30011 }\n").find("address = 10?") !=
        std::string::npos);
  CHECK(doubts("", "feed_pressure_bar = { address = 39999 }\n") == "");
  CHECK(doubts("address = \"0.0.0.0:502\"\n", kFeedAt0).find("only this machine may connect") !=
        std::string::npos);
  CHECK(doubts("address = \"0.0.0.0:502\"\nallow = [\"10.0.0.0/8\"]\n", kFeedAt0) == "");
}

TEST_CASE("a unit is down when the last of its signals is stale") {
  const config::Rig rig = loaded(
      "[safety]\nrod_count = { stale_after_ms = 5000 }\n" +
      section("role = \"client\"\npoll_ms = 20\n", std::string(kFeedAt0) + "rod_count = { address = 1 }\n"));
  CHECK(rig.modbus[0].down_after_s == 5);
  CHECK(loaded(section("role = \"client\"\npoll_ms = 1000\n", kFeedAt0)).modbus[0].down_after_s == 3);
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
  for (const char* wrong : {"", "0", "0770", "0460", "02660", "0668", "rw", "-660", " 660", "1666"})
    CHECK(refusal("[control]\nmode = \"" + std::string(wrong) + "\"\n") ==
          ":2: control.mode: is \"" + std::string(wrong) +
              "\", expected \"0600\"...\"0666\", octal: 6 or 4 or 2 or 0 of group and others");
}
