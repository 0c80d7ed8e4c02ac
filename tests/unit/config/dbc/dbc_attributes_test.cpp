// Attributes of a DBC: their definitions, defaults and values, and what they make of a message.
#include "dbc/dbc_attributes.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "dbc/dbc_tokens.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using config::DbcAttributes;
using config::DbcCursor;
using config::DbcMessage;

namespace {

const std::string kFile = "t.dbc";

struct Attributes {
  using Read = void (DbcAttributes::*)(DbcCursor&);

  /// Reads all of `text`, which is what follows the word of its section.
  void read(Read how, std::string_view text) {
    DbcCursor at(config::dbc_tokens(text), kFile);
    (attributes.*how)(at);
    CHECK(at.at_end());
  }
  void define(std::string_view text) { read(&DbcAttributes::read_definition, text); }
  void by_default(std::string_view text) { read(&DbcAttributes::read_default, text); }
  void set(std::string_view text) { read(&DbcAttributes::read_value, text); }

  DbcMessage message(std::int64_t raw_id = 256, bool extended = true) const {
    DbcMessage m;
    m.extended = extended;
    m.signals.resize(2);
    m.signals[0].name = "A", m.signals[1].name = "B";
    attributes.apply(raw_id, m);
    return m;
  }

  DbcAttributes attributes;
};

}  // namespace

TEST_CASE("attributes of every kind of object and of every type are defined") {
  for (const char* object : {"", "BO_ ", "SG_ ", "BU_ ", "EV_ "})
    for (const char* type :
         {"INT 0 10", "HEX 0 255", "FLOAT -1.5 1.5", "STRING", "ENUM \"a\",\"b\"", "ENUM \"a\"", "INT"}) {
      CAPTURE(object);
      CAPTURE(type);
      CHECK(test::complaint([&] { Attributes().define(object + std::string("\"X\" ") + type + ";"); }) == "");
    }
  const auto refused = [](const char* text) { return test::complaint([&] { Attributes().define(text); }); };
  CHECK(refused("XX_ \"X\" INT 0 1;").find("found 'XX_', expected the name of an attribute in quotes") !=
        std::string::npos);
  CHECK(refused("BO_ X INT 0 1;").find("expected the name of an attribute in quotes") != std::string::npos);
  CHECK(refused("BO_ \"X\" INT 0 1").find("the file ends, expected ';'") != std::string::npos);
  CHECK(refused("BO_ \"X\";").find("found ';', expected INT, HEX, FLOAT, STRING or ENUM") !=
        std::string::npos);
}

TEST_CASE("values of every kind of object are read, those of messages are kept") {
  Attributes a;
  a.set("\"Bus\" \"CAN\";");
  a.set("\"X\" BU_ Node 3;");
  a.set("\"X\" EV_ Variable 3;");
  a.set("\"X\" SG_ 256 A 3;");
  CHECK(a.message().cycle_s == 0);
  a.set("\"GenMsgCycleTime\" BO_ 256 50;");
  CHECK(a.message().cycle_s == 0.05);
  CHECK(a.message(257).cycle_s == 0);
  const auto refused = [&](const char* text) { return test::complaint([&] { a.set(text); }); };
  CHECK(refused("\"X\" BO_ A 3;").find("expected a message identifier") != std::string::npos);
  CHECK(refused("\"X\" SG_ 256 3;").find("expected a name") != std::string::npos);
  CHECK(refused("\"X\" BO_ 256;").find("found ';', expected a value") != std::string::npos);
  CHECK(refused("\"X\" BO_ 4294967296 3;").find("from 0 to 4294967295") != std::string::npos);
  CHECK(refused("\"X\" BO_ -1 3;").find("from 0 to 4294967295") != std::string::npos);
}

TEST_CASE("a cycle time is the message's own, else the default, and none unless it is positive") {
  Attributes a;
  a.define("BO_ \"GenMsgCycleTime\" INT 0 10000;");
  CHECK(a.message().cycle_s == 0);
  a.by_default("\"GenMsgCycleTime\" 100;");
  CHECK(a.message().cycle_s == 0.1);
  a.set("\"GenMsgCycleTime\" BO_ 256 20;");
  CHECK(a.message().cycle_s == 0.02);
  CHECK(a.message(7).cycle_s == 0.1);
  for (const char* none : {"0", "-20", "\"often\"", "\"20 ms\""}) {
    CAPTURE(none);
    a.set("\"GenMsgCycleTime\" BO_ 256 " + std::string(none) + ";");
    CHECK(a.message().cycle_s == 0);
  }
  a.set("\"GenMsgCycleTime\" BO_ 256 \"20\";");
  CHECK(a.message().cycle_s == 0.02);
}

TEST_CASE("a message of 29 bits is J1939 when its frame format says so, by word or by index") {
  const auto j1939 = [](const char* value, bool extended = true) {
    Attributes a;
    a.define("BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"ExtendedCAN\",\"reserved\",\"J1939PG\";");
    a.by_default("\"VFrameFormat\" \"StandardCAN\";");
    if (*value != 0) a.set("\"VFrameFormat\" BO_ 256 " + std::string(value) + ";");
    return a.message(256, extended).j1939;
  };
  CHECK(j1939("3"));
  CHECK(j1939("\"J1939PG\""));
  CHECK(j1939("\"3\""));
  CHECK_FALSE(j1939("3", false));
  for (const char* other : {"", "0", "1", "2", "4", "-1", "\"ExtendedCAN\"", "\"j1939pg\""}) {
    CAPTURE(other);
    CHECK_FALSE(j1939(other));
  }
  Attributes undefined;  // without its words an index says nothing
  undefined.set("\"VFrameFormat\" BO_ 256 3;");
  CHECK_FALSE(undefined.message().j1939);
  Attributes by_default;
  by_default.define("BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"J1939PG\";");
  by_default.by_default("\"VFrameFormat\" 1;");
  CHECK(by_default.message().j1939);
}

TEST_CASE("a word that looks like an index is the word") {
  Attributes a;
  a.define("BO_ \"SystemMessageLongSymbol\" ENUM \"1\",\"one\";");
  a.set("\"SystemMessageLongSymbol\" BO_ 256 1;");
  CHECK(a.message().long_name == "1");
  a.set("\"SystemMessageLongSymbol\" BO_ 256 0;");
  CHECK(a.message().long_name == "1");  // the first
  a.define("BO_ \"SystemMessageLongSymbol\" ENUM \"more\";");
  a.set("\"SystemMessageLongSymbol\" BO_ 256 2;");
  CHECK(a.message().long_name == "more");
  a.set("\"SystemMessageLongSymbol\" BO_ 256 3;");
  CHECK(a.message().long_name == "3");
}

TEST_CASE("a signal's long name is that of its message and of no other's") {
  Attributes a;
  a.set("\"SystemSignalLongSymbol\" SG_ 256 A \"TheFirst\";");
  a.set("\"SystemSignalLongSymbol\" SG_ 257 B \"OfAnother\";");
  a.set("\"GenSigStartValue\" SG_ 256 B 7;");
  a.set("\"SystemSignalLongSymbol\" BU_ B \"OfANode\";");
  CHECK(a.message().signals[0].long_name == "TheFirst");
  CHECK(a.message().signals[1].long_name.empty());
  CHECK(a.message(257).signals[1].long_name == "OfAnother");
}
