// Which fields of a DBC a bus can read, and which ranges of a DBC say nothing.
#include <doctest/doctest.h>

#include "config/rig/rig_texts.hpp"

using namespace rigsound;
using namespace rigsound::test;

namespace {

const std::string kCanHead = "[[can]]\ninterface = \"can0\"\ndbc = \"a.dbc\"\n";

/// The rig whose feed pressure is the one signal of this message.
config::Rig rig_of_field(const std::string& message, const std::string& signal,
                         const std::string& keys = "") {
  const TemporaryFolder folder;
  folder.write("a.dbc", "BO_ " + message + " A\n SG_ S : " + signal + " A\n");
  return config::load_rig(
      folder.write("rig.toml", kCanHead + keys + "[can.signals]\nfeed_pressure_bar = \"M.S\"\n"));
}

/// What is said of it behind the name of its DBC; empty: it is read.
std::string flaw_of(const std::string& message, const std::string& signal, const std::string& keys = "") {
  const std::string said = complaint([&] { rig_of_field(message, signal, keys); });
  const std::size_t at = said.find("M.S: ");
  return at == std::string::npos ? said : said.substr(at + 5);
}

bool doubted(const std::string& message, const std::string& signal, const std::string& keys = "") {
  return !rig_of_field(message, signal, keys).doubts.empty();
}

}  // namespace

TEST_CASE("a field has at most 64 bits and lies in the bytes that its message has") {
  CHECK(flaw_of("1 M: 8", "0|64@1+ (1,0) [0|0] \"\"").empty());
  CHECK(flaw_of("1 M: 8", "0|65@1+ (1,0) [0|0] \"\"") == "is longer than 64 bits");
  CHECK(flaw_of("1 M: 4", "24|8@1+ (1,0) [0|0] \"\"").empty());
  CHECK(flaw_of("1 M: 4", "25|8@1+ (1,0) [0|0] \"\"") == "does not fit into the 4 bytes of its frame");
  CHECK(flaw_of("1 M: 12", "64|8@1+ (1,0) [0|0] \"\"") == "does not fit into the 8 bytes of its frame");
  CHECK(flaw_of("1 M: 12", "64|8@1+ (1,0) [0|0] \"\"", "fd = true\n").empty());
  CHECK(flaw_of("1 M: 12", "96|8@1+ (1,0) [0|0] \"\"", "fd = true\n") ==
        "does not fit into the 12 bytes of its frame");
  CHECK(flaw_of("1 M: 1785", "512|8@1+ (1,0) [0|0] \"\"", "fd = true\n") ==
        "does not fit into the 64 bytes of its frame");
  CHECK(flaw_of("1 M: 8", "0|8@1+ (0,0) [0|0] \"\"") == "has a scale of 0");
}

TEST_CASE("a standard identifier ends at 2047") {
  CHECK(flaw_of("2047 M: 8", "0|8@1+ (1,0) [0|0] \"\"").empty());
  CHECK(flaw_of("2048 M: 8", "0|8@1+ (1,0) [0|0] \"\"") ==
        "is in a message whose identifier has more than 11 bits, but not bit 31 set");
  CHECK(flaw_of("2147485696 M: 8", "0|8@1+ (1,0) [0|0] \"\"").empty());
}

TEST_CASE("J1939 is a matter of 29 bits, whoever asks for it") {
  const auto j1939 = [](const char* id, const char* keys) {
    return rig_of_field(std::string(id) + " M: 8", "0|8@1+ (1,0) [0|0] \"\"", keys)
        .can[0]
        .routes[0]
        .match.j1939;
  };
  CHECK(j1939("2566844672", "j1939 = true\n"));
  CHECK_FALSE(j1939("2566844672", "j1939 = false\n"));
  CHECK_FALSE(j1939("2566844672", ""));
  CHECK_FALSE(j1939("256", "j1939 = true\n"));
  CHECK(flaw_of("2566844672 M: 8", "0|8@1+ (1,0) [0|0] \"\"", "j1939 = true\n").empty());
  CHECK(flaw_of("2566844672 M: 9", "0|8@1+ (1,0) [0|0] \"\"", "j1939 = true\n").rfind("is in a J1939", 0) ==
        0);
  CHECK(flaw_of("2566844672 M: 9", "0|8@1+ (1,0) [0|0] \"\"", "j1939 = true\nfd = true\n").empty());
}

TEST_CASE("a range that is all of the field says nothing, whatever its offset") {
  CHECK_FALSE(doubted("1 M: 8", "0|16@1+ (0.01,0) [0|655.35] \"bar\""));
  CHECK_FALSE(doubted("1 M: 8", "0|16@1+ (0.01,100) [100|755.35] \"bar\""));
  CHECK_FALSE(doubted("1 M: 8", "0|16@1+ (0.01,-327.68) [-327|327.67] \"bar\""));  // to three digits
  CHECK(doubted("1 M: 8", "0|16@1+ (0.01,0) [0|600] \"bar\""));
  CHECK(doubted("1 M: 8", "0|16@1+ (0.01,0) [20|655.35] \"bar\""));
  CHECK(doubted("1 M: 8", "0|16@1+ (0.01,100) [100|600] \"bar\""));
  CHECK(doubted("1 M: 8", "0|16@1- (0.01,0) [0|655.35] \"bar\""));  // a sign leaves it half of that
}

TEST_CASE("of a J1939 field the values above 250/255 mean something else, so its range may end there") {
  const std::string valid = "0|16@1+ (0.01,0) [0|642.55] \"bar\"",
                    above = "0|16@1+ (0.01,100) [100|742.55] \"bar\"";
  CHECK_FALSE(doubted("2566844672 M: 8", valid, "j1939 = true\n"));
  CHECK_FALSE(doubted("2566844672 M: 8", above, "j1939 = true\n"));
  for (const char* all : {"0|16@1+ (0.01,0) [0|655.35] \"bar\"", "0|16@1+ (0.01,100) [100|755.35] \"bar\""})
    CHECK_FALSE(doubted("2566844672 M: 8", all, "j1939 = true\n"));
  CHECK(doubted("2566844672 M: 8", valid));
  CHECK(doubted("2566844672 M: 8", above));
}

TEST_CASE("the name of an interface has at most 15 letters, as the kernel has it") {
  const auto said = [](const std::string& name) {
    return refusal("[[can]]\ninterface = \"" + name + "\"\ndbc = \"" + kDbc.string() + "\"\n");
  };
  CHECK(said("can456789012345").empty());
  CHECK(said("can4567890123456") == ":2: can.interface: is too long, expected at most 15 letters");
}

TEST_CASE("a signal in two files is one when every detail of its line and its frame is the same") {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& id, const std::string& signal, const std::string& more = "") {
    folder.write("a.dbc", "BO_ 256 M: 8 A\n SG_ S : 0|16@1+ (1,0) [0|0] \"\" A\n");
    folder.write("b.dbc", "BO_ " + id + " M: 8 A\n SG_ S : " + signal + " [0|0] \"\" A\n" + more);
    const auto rig = folder.write("rig.toml",
                                  "[[can]]\ninterface = \"can0\"\ndbc = [\"a.dbc\", \"b.dbc\"]\n"
                                  "[can.signals]\nfeed_pressure_bar = \"M.S\"\n");
    return complaint([&] { config::load_rig(rig); });
  };
  CHECK(said("256", "0|16@1+ (1,0)").empty());
  for (const char* signal : {"8|16@1+ (1,0)", "0|15@1+ (1,0)", "0|16@0+ (1,0)", "0|16@1- (1,0)",
                             "0|16@1+ (2,0)", "0|16@1+ (1,1)"}) {
    CAPTURE(signal);
    CHECK(said("256", signal).find("expected it in one of them") != std::string::npos);
  }
  for (const char* id : {"257", "2147483904"})
    CHECK(said(id, "0|16@1+ (1,0)").find("expected it in one of them") != std::string::npos);
  CHECK(said("256", "0|16@1+ (1,0)", "VAL_ 256 S 1 \"Error\";\n").find("expected it in one of them") !=
        std::string::npos);
}

TEST_CASE("J1939 messages of one group are one, whoever sends them; a plain one is another") {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& id, const std::string& format) {
    const std::string signal = " SG_ S : 0|16@1+ (1,0) [0|0] \"\" A\n";
    const std::string formats = "BA_DEF_ BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"J1939PG\";\n";
    folder.write("a.dbc",
                 "BO_ 2566844672 M: 8 A\n" + signal + formats + "BA_ \"VFrameFormat\" BO_ 2566844672 1;\n");
    folder.write("b.dbc", "BO_ " + id + " M: 8 A\n" + signal + formats + "BA_ \"VFrameFormat\" BO_ " + id +
                              " " + format + ";\n");
    const auto rig = folder.write("rig.toml",
                                  "[[can]]\ninterface = \"can0\"\ndbc = [\"a.dbc\", \"b.dbc\"]\n"
                                  "[can.signals]\nfeed_pressure_bar = \"M.S\"\n");
    return complaint([&] { config::load_rig(rig); });
  };
  CHECK(said("2566844673", "1").empty());  // of another source address
  CHECK_FALSE(said("2566844928", "1").empty());
  CHECK_FALSE(said("2566844672", "0").empty());
}
