// Where in a JSON text keys and items stand.
#include "json/json_positions.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace rigsound;
using config::item_positions;
using config::key_position;
using config::kNowhere;
using config::line_at;

TEST_CASE("items of a list end with that list") {
  const std::string text = "{\"x\": [{}, {\"a\": [{}]}], \"y\": [{}, {}]}";
  CHECK(item_positions(text, 0) == std::vector<std::size_t>{7, 11});
  CHECK(item_positions(text, text.find("\"y\"")).size() == 2);
  CHECK(item_positions("{\"x\": []}, [{}]", 0).empty());
  CHECK(item_positions("[{}, {", 0).size() == 2);  // it never ends
  CHECK(item_positions("nothing", 0).empty());
}

TEST_CASE("a key is one of its own object, before a colon, and never a text that is a value") {
  const std::string text =
      "{\"a\": \"b\", \"in\": {\"b\": 1}, \"list\": [\"b\", {\"b\": 1}], \"b\": 2}, \"c\": 3";
  CHECK(key_position(text, 0, "b") == text.rfind("\"b\""));
  CHECK(key_position(text, 0, "a") == 1);
  CHECK(key_position(text, text.find("{\"b\""), "b") == text.find("{\"b\"") + 1);
  CHECK(key_position(text, 0, "c") == kNowhere);  // behind its end
  CHECK(key_position(text, 0, "") == kNowhere);
}

TEST_CASE("quotes in a text do not end it, and a text ends with its view") {
  const std::string text = R"({"a": "x\" , \"b\": ", "c\\": 1, "b": 2})";
  CHECK(key_position(text, 0, "b") == text.rfind("\"b\""));
  CHECK(key_position(text, 0, "c\\\\") == text.find("\"c"));
  CHECK(key_position("{\"open, \"b\": 2", 0, "b") == kNowhere);
  CHECK(key_position(std::string_view("{\"abc\": 1}").substr(0, 5), 0, "abc") == kNowhere);
  CHECK(item_positions(std::string_view("[\"a\",{}]").substr(0, 3), 0).empty());
}

TEST_CASE("lines are counted from 1, also behind the end") {
  CHECK(line_at("", 0) == 1);
  CHECK(line_at("a\nb\n", 1) == 1);
  CHECK(line_at("a\nb\n", 2) == 2);
  CHECK(line_at("a\nb\n", 4) == 3);
  CHECK(line_at("a\nb\n", 400) == 3);
}
