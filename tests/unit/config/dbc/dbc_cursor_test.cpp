// Steps over the tokens of a DBC, and what is said where one is not what was expected.
#include "dbc/dbc_cursor.hpp"

#include <doctest/doctest.h>

#include <string>

#include "dbc/dbc_tokens.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using config::DbcCursor;
using config::DbcToken;

namespace {

const std::string kCursorFile = "t.dbc";

DbcCursor cursor(std::string_view text) { return {config::dbc_tokens(text), kCursorFile}; }

}  // namespace

TEST_CASE("whoever looks behind the end sees the end") {
  DbcCursor at = cursor("a b");
  CHECK(at.peek(1).text == "b");
  for (const std::size_t ahead : {2, 3, 4, 100}) {
    CAPTURE(ahead);
    CHECK(at.peek(ahead).kind == DbcToken::Kind::kEnd);
    CHECK(at.peek(ahead).text.empty());
  }
  for (int i = 0; i < 5; ++i) at.take();
  CHECK(at.at_end());
  CHECK(at.peek(1).kind == DbcToken::Kind::kEnd);
}

TEST_CASE("a sign is taken where it stands, and nothing where another does") {
  DbcCursor at = cursor("; x");
  CHECK_FALSE(at.take_sign(':'));
  CHECK(at.take_sign(';'));
  CHECK_FALSE(at.take_sign('x'));  // a word
  CHECK(at.peek().text == "x");
}

TEST_CASE("quotes in a string are those behind a backslash, other backslashes stay") {
  CHECK(cursor(R"("say \"x\" in C:\rig\")").expect_string("a text") == R"(say "x" in C:\rig")");
  CHECK(cursor("\"\"").expect_string("a text").empty());
}

TEST_CASE("numbers may have a plus sign") {
  CHECK(cursor("+2.5").expect_number("a number") == 2.5);
  CHECK(cursor("-2.5").expect_number("a number") == -2.5);
  CHECK(cursor("+3").expect_integer("a number", -5, 5) == 3);
  CHECK(cursor("-5").expect_integer("a number", -5, 5) == -5);
  CHECK(cursor("5").expect_integer("a number", -5, 5) == 5);
}

TEST_CASE("what is found instead is said with line and section, forty letters of it at most") {
  const auto said = [](std::string_view text, auto expect) {
    DbcCursor at = cursor(text);
    at.enter("BO_");
    return test::complaint([&] { expect(at); });
  };
  CHECK(said("\n5", [](DbcCursor& at) { at.expect_word("a node"); }) ==
        "t.dbc:2: BO_: found '5', expected a node");
  CHECK(said("x", [](DbcCursor& at) { at.expect_number("a scale"); }) ==
        "t.dbc:1: BO_: found 'x', expected a scale");
  CHECK(said("x", [](DbcCursor& at) { at.expect_string("a unit"); }) ==
        "t.dbc:1: BO_: found 'x', expected a unit");
  CHECK(said("", [](DbcCursor& at) { at.expect_sign(':'); }) == "t.dbc:1: BO_: the file ends, expected ':'");
  for (const char* number : {"6", "-6", "1.5", "99999999999999999999"})
    CHECK(said(number, [](DbcCursor& at) { at.expect_integer("a size", -5, 5); }) ==
          "t.dbc:1: BO_: found '" + std::string(number) + "', expected a size from -5 to 5");
  const std::string forty(40, 'a');
  CHECK(said(forty + "b", [](DbcCursor& at) { at.expect_sign(':'); }) ==
        "t.dbc:1: BO_: found '" + forty + "', expected ':'");
}
