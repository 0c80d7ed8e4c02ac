#include "rigsound/config/dbc.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <vector>

#include "rigsound/can/signal_reading.hpp"
#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"
#include "test_data.hpp"

using namespace rigsound;
using namespace rigsound::test;
using can::ByteOrder;
using can::ValueType;

namespace {

const config::DbcSignal& signal(const config::Dbc& dbc, const char* message, const char* name) {
  const config::DbcMessage* m = dbc.find(message);
  REQUIRE(m != nullptr);
  const config::DbcSignal* s = m->find(name);
  REQUIRE(s != nullptr);
  return *s;
}

std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges(const config::DbcSignal& s,
                                                            std::size_t selector) {
  REQUIRE(s.layout.selectors.size() > selector);
  return s.layout.selectors[selector].ranges;
}

}  // namespace

TEST_CASE("messages and signals with every detail of their lines") {
  const config::Dbc dbc = config::parse_dbc(R"(VERSION "1"
BU_: Rig Sim
BO_ 2566844672 DRILL: 8 Rig
 SG_ Feed : 0|16@1+ (0.01,0) [0|300] "bar" Sim
 SG_ Slope : 23|12@0- (2.5e-1,-10.5) [-1E2|+1e2] "%" Sim,Rig

BO_ 291 SHORT: 2 Vector__XXX
)",
                                            "t.dbc");
  CHECK(dbc.nodes == std::vector<std::string>{"Rig", "Sim"});
  const config::DbcMessage& drill = *dbc.find("DRILL");
  CHECK(drill.id == 0x18FEF100);
  CHECK(drill.extended);
  CHECK(drill.size == 8);
  CHECK(drill.line == 3);
  CHECK(drill.senders == std::vector<std::string>{"Rig"});
  CHECK_FALSE(dbc.find("SHORT")->extended);
  CHECK(dbc.find("SHORT")->signals.empty());
  const config::DbcSignal& feed = signal(dbc, "DRILL", "Feed");
  CHECK(feed.layout.field.start_bit == 0);
  CHECK(feed.layout.field.length == 16);
  CHECK(feed.layout.field.order == ByteOrder::kIntel);
  CHECK(feed.layout.type == ValueType::kUnsigned);
  CHECK(feed.layout.scale == 0.01);
  CHECK(feed.max == 300);
  CHECK(feed.unit == "bar");
  const config::DbcSignal& slope = signal(dbc, "DRILL", "Slope");
  CHECK(slope.layout.field.order == ByteOrder::kMotorola);
  CHECK(slope.layout.type == ValueType::kSigned);
  CHECK(slope.layout.scale == 0.25);
  CHECK(slope.layout.offset == -10.5);
  CHECK(slope.min == -100);
  CHECK(slope.max == 100);
  CHECK(slope.line == 5);
}

TEST_CASE("white space and newlines may stand between any two tokens, or nowhere") {
  const config::Dbc dbc = config::parse_dbc(
      "BO_\n291\nA\n:\n8\nX\nSG_\nS\n:\n8\n|\n4\n@\n1\n-\n(\n1\n,\n-5\n)\n[\n0\n|\n1\n]\n\"u\"\nX\n,\nY\n"
      "BO_ 292 B:8 X SG_ T m0:0|8@1-(1,-5)[-1|1]\"\"X,Y SG_ M M:8|8@1+(1,0)[0|0]\"\"X",
      "t.dbc");
  CHECK(signal(dbc, "A", "S").layout.offset == -5);
  CHECK(signal(dbc, "A", "S").layout.type == ValueType::kSigned);
  CHECK(signal(dbc, "B", "T").layout.offset == -5);
  CHECK(signal(dbc, "B", "T").layout.selectors.size() == 1);
}

TEST_CASE("attributes give cycle time and J1939 matching, with defaults") {
  const config::Dbc dbc = config::parse_dbc(R"(
BO_ 2364540158 EEC1: 8 X
BO_ 2566844672 PLAIN: 8 X
BO_ 291 STD: 8 X
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 3600000;
BA_DEF_ BO_  "VFrameFormat" ENUM  "StandardCAN","ExtendedCAN","reserved","J1939PG";
BA_DEF_ SG_ "SPN" INT 0 524287;
BA_DEF_ "Scale" FLOAT -1.5 1e3;
BA_DEF_DEF_ "GenMsgCycleTime" 250;
BA_DEF_DEF_ "VFrameFormat" "J1939PG";
BA_ "Scale" 2.5;
BA_ "SPN" SG_ 2364540158 EngSpeed 190;
BA_ "GenMsgCycleTime" BO_ 2364540158 20;
BA_ "VFrameFormat" BO_ 2364540158 3;
BA_ "VFrameFormat" BO_ 2566844672 1;
)",
                                            "t.dbc");
  CHECK(dbc.find("EEC1")->cycle_s == 0.02);
  CHECK(dbc.find("EEC1")->j1939);
  CHECK(dbc.find("PLAIN")->cycle_s == 0.25);
  CHECK_FALSE(dbc.find("PLAIN")->j1939);
  CHECK_FALSE(dbc.find("STD")->j1939);  // a standard identifier has no parameter group
}

TEST_CASE("plain and extended multiplexing select along the whole chain") {
  const config::Dbc dbc = config::parse_dbc(R"(
BO_ 1 A: 8 X
 SG_ Plain : 0|4@1+ (1,0) [0|0] "" X
 SG_ Mode M : 4|4@1+ (1,0) [0|0] "" X
 SG_ Sub m1M : 8|8@1+ (1,0) [0|0] "" X
 SG_ One m1 : 16|8@1+ (1,0) [0|0] "" X
 SG_ Deep m2 : 16|8@1+ (1,0) [0|0] "" X
SG_MUL_VAL_ 1 Deep Sub 2-2, 5-7;
)",
                                            "t.dbc");
  CHECK(signal(dbc, "A", "Plain").layout.selectors.empty());
  CHECK(signal(dbc, "A", "Mode").layout.selectors.empty());
  CHECK(ranges(signal(dbc, "A", "One"), 0) == std::vector<std::pair<std::uint64_t, std::uint64_t>>{{1, 1}});
  const config::DbcSignal& deep = signal(dbc, "A", "Deep");
  REQUIRE(deep.layout.selectors.size() == 2);
  CHECK(ranges(deep, 0) == std::vector<std::pair<std::uint64_t, std::uint64_t>>{{2, 2}, {5, 7}});
  CHECK(deep.layout.selectors[0].field.start_bit == 8);
  CHECK(ranges(deep, 1) == std::vector<std::pair<std::uint64_t, std::uint64_t>>{{1, 1}});
  CHECK(deep.layout.selectors[1].field.start_bit == 4);
}

TEST_CASE("value texts, tables, comments, float types and senders") {
  const config::Dbc dbc = config::parse_dbc(R"(
VAL_TABLE_ Modes 0 "none" 1 "closed" ;
BO_ 1 A: 8 X
 SG_ R : 0|8@1- (1,0) [0|0] "" X
 SG_ F : 8|32@1- (1,0) [0|0] "" X
BO_TX_BU_ 1 : Y,Z;
CM_ "a file comment; with
a second line";
CM_ BO_ 1 "the \"A\" message";
CM_ SG_ 1 R "rattling";
CM_ BU_ X "a node";
VAL_ 1 R 0 "none" 1 "closed" -1 "?" ;
VAL_ SomeVariable 0 "x" ;
SIG_VALTYPE_ 1 F : 1;
SIG_GROUP_ 1 G 1 : R F;
)",
                                            "t.dbc");
  CHECK(dbc.value_tables.at("Modes").at(1) == "closed");
  CHECK(signal(dbc, "A", "R").values.at(-1) == "?");
  CHECK(signal(dbc, "A", "R").comment == "rattling");
  CHECK(dbc.find("A")->comment == "the \"A\" message");
  CHECK(dbc.find("A")->senders == std::vector<std::string>{"X", "Y", "Z"});
  CHECK(signal(dbc, "A", "F").layout.type == ValueType::kFloat32);
}

TEST_CASE("text in Windows-1252 and in UTF-8 comes out as UTF-8") {
  const std::string head = "BO_ 1 A: 8 X\n SG_ T : 0|8@1+ (1,0) [0|0] \"";
  CHECK(signal(config::parse_dbc(head + "\xB0"
                                        "C\" X",
                                 "t.dbc"),
               "A", "T")
            .unit ==
        "\xC2\xB0"
        "C");
  CHECK(signal(config::parse_dbc(head + "\x80\" X", "t.dbc"), "A", "T").unit == "\xE2\x82\xAC");
  CHECK(signal(config::parse_dbc("\xEF\xBB\xBF" + head +
                                     "\xC2\xB0"
                                     "C\" X",
                                 "t.dbc"),
               "A", "T")
            .unit ==
        "\xC2\xB0"
        "C");
}

TEST_CASE("sections nobody knows are skipped, also without a semicolon") {
  const config::Dbc dbc = config::parse_dbc(R"(VERSION ""
NS_ :
 NS_DESC_
 CM_
 BA_DEF_
 BO_TX_BU_
 SG_MUL_VAL_
BS_: 500,1,2
BU_: A
FUTURE_ 1 "x;y" thing : 2;
FUTURE2_ no end
BO_ 1 A: 8 X
)",
                                            "t.dbc");
  CHECK(dbc.messages.size() == 1);
  CHECK(dbc.nodes == std::vector<std::string>{"A"});
}

TEST_CASE("the list of new symbols ends where one of its words begins a section") {
  const config::Dbc dbc = config::parse_dbc(R"(NS_ :
 CM_
 BA_DEF_
 BA_DEF_DEF_
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 9000;
BA_DEF_DEF_ "GenMsgCycleTime" 250;
BO_ 1 A: 8 X
)",
                                            "t.dbc");
  CHECK(dbc.unread.empty());
  REQUIRE(dbc.find("A") != nullptr);
  CHECK(dbc.find("A")->cycle_s == 0.25);
}

TEST_CASE("what is wrong is said with line, section and what was expected") {
  const auto said = [](const char* text) {
    const config::Dbc dbc = config::parse_dbc(text, "t.dbc");
    if (!dbc.unread.empty()) return dbc.unread.front();
    return dbc.messages.empty() ? std::string() : dbc.messages.front().broken;
  };
  CHECK(said("BO_ x A: 8 X") == "t.dbc:1: BO_: found 'x', expected a message identifier");
  CHECK(said("\nBO_ 1 A: 8 X\n SG_ S : 0|0@1+ (1,0) [0|0] \"\" X") ==
        "t.dbc:3: SG_: found '0', expected a length in bits from 1 to 14280");
  CHECK(said("BO_ 1 A: 8 X\n SG_ S : 0|8@1+ (1;0) [0|0] \"\" X") == "t.dbc:2: SG_: found ';', expected ','");
  CHECK(said("BO_ 1 A: 8 X\n SG_ S : 0|8@1+ (1,0) [0|0]") ==
        "t.dbc:2: SG_: the file ends, expected a unit in quotes");
  CHECK(said("BO_ 1 A: 8 X\n SG_ S x3 : 0|8@1+ (1,0) [0|0] \"\" X").find("wrong multiplexing word") !=
        std::string::npos);
  CHECK(said("BO_ 1 A: 8 X\n SG_ S m3x : 0|8@1+ (1,0) [0|0] \"\" X").find("wrong multiplexing word") !=
        std::string::npos);
  CHECK(said("BO_ 1 A: 8 X\n SG_ S m3 : 0|8@1+ (1,0) [0|0] \"\" X").find("has no multiplexor") !=
        std::string::npos);
  CHECK(said("BO_ 1 A: 8 X\n SG_ S m1M : 0|8@1+ (1,0) [0|0] \"\" X\nSG_MUL_VAL_ 1 S S 1-1;")
            .find("depends on itself") != std::string::npos);
}

TEST_CASE("a line that cannot be read costs its message and nothing else") {
  const std::string good = "BO_ 256 M: 8 A\n SG_ S : 0|16@1+ (1,0) [0|4000] \"rpm\" A\n";
  for (const char* broken : {"BO_ 255 Q: 8 A\n SG_ X m : 0|16@1+ (1,0) [0|4000] \"\" A\n",  // opendbc vw_pq
                             "CM_ \"front\"\n",                                             // no semicolon
                             "CM_ SG_ 1 X \"never closed;\n", "VAL_ 77 X 0 ;\n", "BO_ 0x55 Q: 8 A\n",
                             "BA_DEF_ BO_ GenMsgCycleTime INT 0 1;\n"}) {
    INFO(broken);
    for (const std::string& text : {broken + good, good + broken, good + broken + "BO_ 257 N: 8 A\n"}) {
      const config::Dbc dbc = config::parse_dbc(text, "t.dbc");
      CHECK(signal(dbc, "M", "S").max == 4000);
      CHECK(dbc.find("M")->broken.empty());
      CHECK((text.find(" N:") == std::string::npos) == (dbc.find("N") == nullptr));
    }
  }
  const config::Dbc dbc = config::parse_dbc(
      good + "BO_ 3 Q: 8 A\n SG_ X m : 0|8@1+ (1,0) [0|1] \"\" A\n" + "SG_ Y : 8|8@1+ (1,0) [0|1] \"\" A\n",
      "t.dbc");
  CHECK(dbc.find("Q")->broken.rfind("t.dbc:4: SG_: signal X has a wrong multiplexing word", 0) == 0);
  CHECK(dbc.unread.empty());                                            // it is known by name
  CHECK(config::parse_dbc("CM_ 5;\n" + good, "t.dbc").unread.empty());  // is no message
  CHECK(config::parse_dbc("BO_ 0x55 Q: 8 A\n" + good, "t.dbc").unread.size() == 1);
  // What a section says of a message makes it what it is.
  CHECK_FALSE(config::parse_dbc(good + "SIG_VALTYPE_ 256 S : 7;", "t.dbc").find("M")->broken.empty());
}

TEST_CASE("long names beside the short ones") {
  const config::Dbc dbc = config::parse_dbc(
      "BO_ 256 M: 8 A\n SG_ Short : 0|16@1+ (1,0) [0|4000] \"rpm\" A\n SG_ S : 16|8@1+ (1,0) [0|1] \"\" A\n"
      "BA_DEF_DEF_ \"SystemSignalLongSymbol\" \"\";\n"
      "BA_ \"SystemSignalLongSymbol\" SG_ 256 Short \"TheLongName\";\n"
      "BA_ \"SystemMessageLongSymbol\" BO_ 256 \"TheLongMessage\";\n",
      "t.dbc");
  CHECK(signal(dbc, "M", "TheLongName").name == "Short");
  CHECK(signal(dbc, "TheLongMessage", "Short").name == "Short");
  CHECK(dbc.find("") == nullptr);
  CHECK(dbc.find("M")->find("") == nullptr);
}

TEST_CASE("text that is none is named for what it is") {
  const auto said = [](std::string_view text) {
    return complaint([&] { config::parse_dbc(text, "t.dbc"); });
  };
  using namespace std::string_view_literals;
  CHECK(said("\xFF\xFEV\0E\0"sv).find("is UTF-16, expected UTF-8") != std::string::npos);
  CHECK(said("V\0E\0R\0"sv).find("is UTF-16") != std::string::npos);
  CHECK(said("VERSION \"\"\rBU_: A\rBO_ 256 M: 8 A\r").find("line ends of CR alone") != std::string::npos);
  CHECK(said("VERSION \"\"\r\nBU_: A\r\n") == "");
  CHECK(config::parse_dbc("BO_ 256 M: 8 A\n SG_ \xD6l : 0|8@1+ (1,0) [0|1] \"\" A\n", "t.dbc")
            .messages.size() == 1);
}

TEST_CASE("real files: every message and signal their lines declare") {
  const auto folder = tests::test_data("real DBC files", "dbc");
  if (!folder) return;
  for (const char* name : {"j1939.dbc", "vw_mqb.dbc", "comma_body.dbc"}) {
    INFO(name);
    const std::string text = content(*folder / name);
    std::size_t messages = 0, signals = 0, start = 0;
    while (start < text.size()) {  // line by line, the plain way
      const std::size_t end = std::min(text.find('\n', start), text.size());
      std::string line = text.substr(start, end - start);
      line.erase(0, line.find_first_not_of(" \t"));
      messages += line.rfind("BO_ ", 0) == 0;
      signals += line.rfind("SG_ ", 0) == 0;
      start = end + 1;
    }
    const config::Dbc dbc = config::load_dbc(*folder / name);
    std::size_t found = 0;
    for (const config::DbcMessage& message : dbc.messages) found += message.signals.size();
    CHECK(messages > 5);
    CHECK(dbc.messages.size() == messages);
    CHECK(found == signals);
  }
  const config::Dbc j1939 = config::load_dbc(*folder / "j1939.dbc");
  CHECK(j1939.find("EEC1")->j1939);
  CHECK(j1939.find("EEC1")->id == 0x0CF00400);
  const config::DbcSignal& speed = signal(j1939, "EEC1", "EngSpeed");
  CHECK(speed.layout.field.start_bit == 24);
  CHECK(speed.layout.scale == 0.125);
  const config::Dbc body = config::load_dbc(*folder / "comma_body.dbc");
  can::Frame frame;
  frame.size = 8;
  frame.data = {0xFE, 0x0C, 0x01, 0xF4};
  CHECK(can::read_signal(signal(body, "MOTORS_DATA", "SPEED_L").layout, can::RawValues::kAll, frame)->value ==
        -500);
  CHECK(can::read_signal(signal(body, "MOTORS_DATA", "SPEED_R").layout, can::RawValues::kAll, frame)->value ==
        500);
}
