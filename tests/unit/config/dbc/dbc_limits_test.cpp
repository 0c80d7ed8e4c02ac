// The numbers of a DBC: the largest that its lines may hold, and one beyond.
#include <doctest/doctest.h>

#include <string>

#include "rigsound/config/dbc.hpp"

using namespace rigsound;

namespace {

/// What is said of the first message of `text`; empty: it is whole.
std::string said_of_first(const std::string& text) {
  const config::Dbc dbc = config::parse_dbc(text, "t.dbc");
  if (!dbc.unread.empty()) return dbc.unread.front();
  REQUIRE_FALSE(dbc.messages.empty());
  return dbc.messages.front().broken;
}

std::string said_of_signal(const std::string& field, const std::string& scaling = "(1,0) [0|0]") {
  return said_of_first("BO_ 1 A: 8 X\n SG_ S : " + field + " " + scaling + " \"\" X\n");
}

std::string wrong_in_signal(const std::string& found, const std::string& expected) {
  return "t.dbc:2: SG_: found '" + found + "', expected " + expected;
}

}  // namespace

TEST_CASE("a message has 0 to 1785 bytes, the most that J1939's transport protocol brings") {
  CHECK(said_of_first("BO_ 1 A: 0 X\n").empty());
  CHECK(said_of_first("BO_ 1 A: 1785 X\n").empty());
  for (const char* size : {"1786", "-1", "8.5"}) {
    CAPTURE(size);
    CHECK(said_of_first("BO_ 1 A: " + std::string(size) + " X\n") ==
          "t.dbc:1: BO_: found '" + std::string(size) +
              "', expected the size of a message in bytes from 0 to 1785");
  }
}

TEST_CASE("an identifier has 32 bits, the highest of which says that 29 of them count") {
  const auto first = [](const std::string& id) {
    return config::parse_dbc("BO_ " + id + " A: 8 X\n", "t.dbc").messages.at(0);
  };
  CHECK(first("0").id == 0);
  CHECK(first("2147483647").id == 0x1FFFFFFF);
  CHECK_FALSE(first("2147483647").extended);
  CHECK(first("2147483648").id == 0);
  CHECK(first("2147483648").extended);
  CHECK(first("4294967295").id == 0x1FFFFFFF);
  for (const char* id : {"4294967296", "-1", "99999999999999999999"}) {
    CAPTURE(id);
    CHECK(said_of_first("BO_ " + std::string(id) + " A: 8 X\n") ==
          "t.dbc:1: BO_: found '" + std::string(id) +
              "', expected a message identifier from 0 to 4294967295");
  }
}

TEST_CASE("a field lies in the 14280 bits of the largest message") {
  CHECK(said_of_signal("0|1@1+").empty());
  CHECK(said_of_signal("14279|1@1+").empty());
  CHECK(said_of_signal("14280|1@1+") == wrong_in_signal("14280", "a start bit from 0 to 14279"));
  CHECK(said_of_signal("-1|1@1+") == wrong_in_signal("-1", "a start bit from 0 to 14279"));
  CHECK(said_of_signal("0|14280@1+").empty());
  CHECK(said_of_signal("0|14281@1+") == wrong_in_signal("14281", "a length in bits from 1 to 14280"));
  CHECK(said_of_signal("0|0@1+") == wrong_in_signal("0", "a length in bits from 1 to 14280"));
}

TEST_CASE("a byte order is 0 or 1, a sign + or -") {
  CHECK(said_of_signal("7|8@0-").empty());
  CHECK(said_of_signal("0|8@2+") == wrong_in_signal("2", "a byte order, 0 or 1, from 0 to 1"));
  CHECK(said_of_signal("0|8@1*") == wrong_in_signal("*", "'+'"));
}

TEST_CASE("scale, offset and range are numbers that a double holds") {
  CHECK(said_of_signal("0|8@1+", "(1e308,-1e308) [-1.5|+2.5]").empty());
  CHECK(said_of_signal("0|8@1+", "(1e999,0) [0|0]") == wrong_in_signal("1e999", "a scale"));
  CHECK(said_of_signal("0|8@1+", "(1.5.2,0) [0|0]") == wrong_in_signal("1.5.2", "a scale"));
  CHECK(said_of_signal("0|8@1+", "(1,1e999) [0|0]") == wrong_in_signal("1e999", "an offset"));
  CHECK(said_of_signal("0|8@1+", "(1,0) [x|0]") == wrong_in_signal("x", "the least value"));
  CHECK(said_of_signal("0|8@1+", "(1,0) [0|-1e999]") == wrong_in_signal("-1e999", "the greatest value"));
}

TEST_CASE("a type of value is 0, 1 or 2: a whole number, a float, a double") {
  const auto read_as = [](const std::string& type) {
    const config::Dbc dbc = config::parse_dbc(
        "BO_ 1 A: 8 X\n SG_ S : 0|64@1- (1,0) [0|0] \"\" X\nSIG_VALTYPE_ 1 S : " + type + ";\n", "t.dbc");
    return dbc.messages.at(0);
  };
  CHECK(read_as("0").signals.at(0).layout.type == can::ValueType::kSigned);
  CHECK(read_as("1").signals.at(0).layout.type == can::ValueType::kFloat32);
  CHECK(read_as("2").signals.at(0).layout.type == can::ValueType::kFloat64);
  CHECK(read_as("2").broken.empty());
  for (const char* other : {"3", "-1"}) {
    CAPTURE(other);
    CHECK(read_as(other).broken == "t.dbc:3: SIG_VALTYPE_: found '" + std::string(other) +
                                       "', expected 0 (integer), 1 (float) or 2 (double), from 0 to 2");
  }
}

TEST_CASE("a multiplexor's value is any whole number that is not negative") {
  const auto said = [](const std::string& ranges) {
    return said_of_first(
        "BO_ 1 A: 8 X\n SG_ Mode M : 0|8@1+ (1,0) [0|0] \"\" X\n SG_ S m0 : 8|8@1+ (1,0) [0|0] \"\" X\n"
        "SG_MUL_VAL_ 1 S Mode " +
        ranges + ";\n");
  };
  const std::string expected = "expected a multiplexor value from 0 to 9223372036854775807";
  CHECK(said("0-9223372036854775807").empty());
  CHECK(said("0-9223372036854775808") == "t.dbc:4: SG_MUL_VAL_: found '9223372036854775808', " + expected);
  CHECK(said("-1-1") == "t.dbc:4: SG_MUL_VAL_: found '-1', " + expected);
  CHECK(said("0 1") == "t.dbc:4: SG_MUL_VAL_: found '1', expected '-'");
}

TEST_CASE("raw values of texts that 64 bits cannot hold are the nearest that they nearly hold") {
  const auto raw = [](const std::string& value) {
    const config::Dbc dbc = config::parse_dbc(
        "BO_ 1 A: 8 X\n SG_ S : 0|64@1- (1,0) [0|0] \"\" X\nVAL_ 1 S " + value + " \"x\";\n", "t.dbc");
    return dbc.messages.at(0).signals.at(0).values.begin()->first;
  };
  CHECK(raw("1e30") == 9000000000000000000);
  CHECK(raw("-1e30") == -9000000000000000000);
  CHECK(raw("3.0") == 3);
}
