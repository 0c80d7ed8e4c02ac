// What a rig takes from DBC files, and what it doubts of them.
#include <doctest/doctest.h>

#include "config/rig/rig_texts.hpp"

using namespace rigsound;
using namespace rigsound::test;
namespace fs = std::filesystem;

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

TEST_CASE("the rig's scale and offset come on top of the DBC's, a share in percent brings its own") {
  // (raw 0.5 + 3) 2 - 5 = raw + 1
  const config::Rig rig = with_signals(
      " SG_ Feed : 0|16@1+ (0.5,3) [0|0] \"\" A\n SG_ Load : 16|8@1+ (0.5,10) [0|0] \"%\" A\n",
      "feed_pressure_bar = { signal = \"M.Feed\", scale = 2, offset = -5 }\nengine_load = \"M.Load\"\n"
      "flushing = { signal = \"M.Load\", offset = 0.25 }\n");
  REQUIRE(rig.can[0].routes.size() == 3);
  CHECK(rig.can[0].routes[0].layout.scale == 1);
  CHECK(rig.can[0].routes[0].layout.offset == 1);
  CHECK(rig.can[0].routes[1].layout.scale == doctest::Approx(0.005));
  CHECK(rig.can[0].routes[1].layout.offset == doctest::Approx(0.1));
  CHECK(rig.can[0].routes[2].layout.scale == doctest::Approx(0.005));
  CHECK(rig.can[0].routes[2].layout.offset == doctest::Approx(0.35));
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

  const auto selected_by = [](const char* value) {
    return "BO_ 258 P: 8 A\n SG_ Mux M : 0|8@1+ (1,0) [0|0] \"\" A\n SG_ Speed " + std::string(value) +
           " : 8|16@1+ (1,0) [0|0] \"rpm\" A\n";
  };
  folder.write("e.dbc", selected_by("m1"));
  folder.write("f.dbc", "\n" + selected_by("m1"));
  folder.write("g.dbc", selected_by("m2"));
  const std::string selected = "engine_rpm = \"P.Speed\"\n";
  CHECK(config::load_rig(rig("[\"e.dbc\", \"f.dbc\"]", selected)).can[0].routes.size() == 1);
  CHECK(complaint([&] { config::load_rig(rig("[\"e.dbc\", \"g.dbc\"]", selected)); }).find("otherwise") !=
        std::string::npos);
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
