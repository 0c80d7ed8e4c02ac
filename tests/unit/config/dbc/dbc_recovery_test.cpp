// Where reading of a DBC goes on behind what it cannot read, and what is no beginning of a section.
#include <doctest/doctest.h>

#include <string>

#include "rigsound/config/dbc.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

const std::string kWhole = "BO_ 256 M: 8 A\n SG_ S : 0|16@1+ (1,0) [0|4000] \"rpm\" A\n";

config::Dbc read_back(const std::string& text) { return config::parse_dbc(text, "t.dbc"); }

}  // namespace

TEST_CASE("behind an error reading goes on where a line begins with a section, not inside a line") {
  for (const std::string broken :
       {"CM_ \"never closed, see BO_ 7 GHOST: 8 A;\n", "VAL_ x y BO_ 7 GHOST: 8 A\n",
        "CM_ \"never closed\nand more; BO_ 7 GHOST: 8 A\n", "CM_ BU_ 5\n\"BO_\" ; BO_ 7 GHOST: 8 A\n"}) {
    CAPTURE(broken);
    const config::Dbc dbc = read_back(broken + kWhole);
    CHECK(dbc.find("GHOST") == nullptr);
    REQUIRE(dbc.find("M") != nullptr);
    CHECK(dbc.find("M")->signals.size() == 1);
  }
}

TEST_CASE("signals behind a broken one are of the broken message and of no other") {
  const config::Dbc dbc =
      read_back("BO_ 1 A: 8 X\n SG_ Bad : x\n SG_ Later : 0|8@1+ (1,0) [0|0] \"\" X\n" + kWhole);
  REQUIRE(dbc.messages.size() == 2);
  CHECK(dbc.messages[0].broken == "t.dbc:2: SG_: found 'x', expected a start bit");
  CHECK(dbc.messages[0].signals.empty());
  CHECK(dbc.messages[1].broken.empty());
  CHECK(dbc.messages[1].signals.size() == 1);
}

TEST_CASE("of two things that are wrong with a message the first is told") {
  const config::Dbc dbc = read_back(kWhole + "SIG_VALTYPE_ 256 S : 7;\nSIG_VALTYPE_ 256 S : 8;\n");
  CHECK(dbc.messages.at(0).broken.rfind("t.dbc:3: SIG_VALTYPE_: found '7'", 0) == 0);
}

TEST_CASE("an unknown section ends with its semicolon or before a line that begins a known one") {
  for (const char* unknown :
       {"FUTURE_ BO_ 7 GHOST: 8 A;\n", "FUTURE_ x BO_ 7 GHOST: 8 A\n", "FUTURE_ 1 \"BO_\" BO_ 7 GHOST: 8 A\n",
        "FUTURE_\nmore BO_ 7 GHOST: 8 A;\n", "FUTURE_ x\n\"BO_\" BO_ 7 GHOST: 8 A;\n"}) {
    CAPTURE(unknown);
    const config::Dbc dbc = read_back(unknown + kWhole);
    CHECK(dbc.find("GHOST") == nullptr);
    CHECK(dbc.find("M") != nullptr);
  }
  CHECK(read_back("FUTURE_ 1; BO_ 7 SAME_LINE: 8 A\n").find("SAME_LINE") != nullptr);
  CHECK(read_back("\"BO_\" 7 GHOST: 8 A;\n" + kWhole).messages.size() == 1);  // a string is no section
}

TEST_CASE("a message behind the list of new symbols is told of when it cannot be read") {
  const config::Dbc dbc = read_back("NS_ :\n CM_\nBO_ x A: 8 X\n" + kWhole);
  REQUIRE(dbc.unread.size() == 1);
  CHECK(dbc.unread[0] == "t.dbc:3: BO_: found 'x', expected a message identifier");
  CHECK(dbc.find("M") != nullptr);
}

TEST_CASE("an attribute of any object ends the list of new symbols") {
  for (const char* object : {"BO_", "SG_", "BU_", "EV_"}) {
    CAPTURE(object);
    const config::Dbc dbc = read_back("NS_ :\n CM_\n BA_DEF_\nBA_DEF_ " + std::string(object) +
                                      " \"VFrameFormat\" ENUM \"other\",\"J1939PG\";\nBO_ 2566844672 M: 8 A\n"
                                      "BA_ \"VFrameFormat\" BO_ 2566844672 1;\n");
    REQUIRE(dbc.find("M") != nullptr);
    CHECK(dbc.find("M")->j1939);
  }
}

TEST_CASE("words of the list of new symbols are no objects because a string comes later") {
  const config::Dbc dbc = read_back(
      "NS_ :\n CM_\n SG_MUL_VAL_\nBA_DEF_ \"VFrameFormat\" ENUM \"J1939PG\";\n"
      "BO_ 2566844672 M: 8 A\nBA_ \"VFrameFormat\" BO_ 2566844672 0;\n");
  REQUIRE(dbc.find("M") != nullptr);
  CHECK(dbc.find("M")->j1939);
}

TEST_CASE("nodes end where a section begins") {
  const config::Dbc dbc = read_back("BU_: A B\nVAL_TABLE_ Modes 0 \"none\" ;\n" + kWhole);
  CHECK(dbc.nodes == std::vector<std::string>{"A", "B"});
  CHECK(dbc.value_tables.at("Modes").at(0) == "none");
  CHECK(read_back("BU_: A").nodes == std::vector<std::string>{"A"});
  CHECK(read_back("BU_:\n" + kWhole).nodes.empty());
  CHECK(read_back("BU_: A;\n" + kWhole).find("M") != nullptr);
}

TEST_CASE("a message may have no sender") {
  const config::Dbc dbc = read_back("BO_ 1 A: 8\n SG_ S : 0|8@1+ (1,0) [0|0] \"\" X\nBO_ 2 B: 8\n" + kWhole);
  CHECK(dbc.find("A")->senders.empty());
  CHECK(dbc.find("A")->signals.size() == 1);
  CHECK(dbc.find("B")->senders.empty());
  CHECK(dbc.find("M")->senders == std::vector<std::string>{"A"});
}

TEST_CASE("signals that no message carries are left out") {
  const config::Dbc dbc = read_back(
      "BO_ 3221225472 VECTOR__INDEPENDENT_SIG_MSG: 0 X\n SG_ Loose : 0|8@1+ (1,0) [0|0] \"\" X\n" + kWhole);
  CHECK(dbc.messages.size() == 1);
  CHECK(dbc.unread.empty());
}

TEST_CASE("sections about what the file does not hold change nothing") {
  const config::Dbc dbc =
      read_back(kWhole +
                "SIG_VALTYPE_ 256 Other : 1;\nSIG_VALTYPE_ 7 S : 1;\nSG_MUL_VAL_ 256 "
                "Other S 1-1;\nSG_MUL_VAL_ 256 S S 1-1;\nSG_MUL_VAL_ 7 S S 1-1;\nBO_TX_BU_ 7 : Q;\nCM_ BO_ 7 "
                "\"x\";\nCM_ SG_ 256 Other \"x\";\nCM_ SG_ 7 S \"x\";\nVAL_ 7 S 0 \"x\";\n"
                "VAL_ 256 Other 0 \"x\";\n");
  REQUIRE(dbc.messages.size() == 1);
  const config::DbcMessage& m = dbc.messages[0];
  CHECK(m.broken.empty());
  CHECK(m.comment.empty());
  CHECK(m.senders == std::vector<std::string>{"A"});
  CHECK(m.signals[0].layout.type == can::ValueType::kUnsigned);
  CHECK(m.signals[0].layout.selectors.empty());
  CHECK(m.signals[0].comment.empty());
  CHECK(m.signals[0].values.empty());
}

TEST_CASE("texts of a value are those of the table that is named") {
  const config::Dbc dbc =
      read_back("VAL_TABLE_ Modes 0 \"none\" 1 \"closed\" ;\n" + kWhole + "VAL_ 256 S Modes ;\n");
  CHECK(dbc.messages.at(0).signals.at(0).values.at(1) == "closed");
}

TEST_CASE("a multiplexor that is itself multiplexed is not the plain one, whichever comes first") {
  const auto parent = [](const char* plain, const char* inner) {
    const config::Dbc dbc =
        read_back("BO_ 1 A: 8 X\n SG_ " + std::string(plain) + " M : 0|8@1+ (1,0) [0|0] \"\" X\n SG_ " +
                  inner + " m1M : 8|8@1+ (1,0) [0|0] \"\" X\n SG_ S m2 : 16|8@1+ (1,0) [0|0] \"\" X\n");
    const config::DbcSignal* s = dbc.messages.at(0).find("S");
    REQUIRE(s != nullptr);
    REQUIRE(s->layout.selectors.size() == 1);
    return s->layout.selectors[0].field.start_bit;
  };
  CHECK(parent("A", "B") == 0);
  CHECK(parent("B", "A") == 0);
}

TEST_CASE("words of multiplexing are M, and m with a number and perhaps M") {
  const auto broken = [](const char* word) {
    return read_back("BO_ 1 A: 8 X\n SG_ Mode M : 0|8@1+ (1,0) [0|0] \"\" X\n SG_ S " + std::string(word) +
                     " : 8|8@1+ (1,0) [0|0] \"\" X\n")
        .messages.at(0)
        .broken;
  };
  for (const char* word : {"m0", "m18446744073709551615", "m7M"}) CHECK(broken(word).empty());
  for (const char* word : {"m", "mM", "M1", "x1", "mx", "m1x", "m1MM", "m18446744073709551616"}) {
    CAPTURE(word);
    CHECK(broken(word) == "t.dbc:3: SG_: signal S has a wrong multiplexing word, expected M, m0, m0M, ...");
  }
}

TEST_CASE("a byte order mark of UTF-16 is one in either order, whatever follows") {
  for (const char* mark : {"\xFF\xFE", "\xFE\xFF"}) {
    CHECK(test::complaint([&] { read_back(mark + kWhole); }) ==
          "t.dbc: is UTF-16, expected UTF-8 or Windows-1252: iconv -f UTF-16 -t UTF-8");
  }
}
