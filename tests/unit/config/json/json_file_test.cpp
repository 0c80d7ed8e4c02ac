#include "json/json_file.hpp"

#include <doctest/doctest.h>

#include "json/json_positions.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::test;
using config::JsonFile;

namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

}  // namespace

TEST_CASE("nested objects say where they stand, however often a key occurs") {
  TemporaryFolder folder;
  const auto file = folder.write("a.json", R"({
  "rho": 1, "note": "{ \"rho\": [ ",
  "points": [
    {"rho": 2,
     "in": {"rho": 3}},
    {"in": {"x": [ {"rho": 4} ],
     "rho": 5}, "rho":
      6}
  ]
})");
  const JsonFile json(file);
  const Range none{0, 0};
  const auto refused = [&](const JsonFile& in, const std::string& expected) {
    CHECK(complaint([&] { in.number("rho", none); }) == file.string() + expected);
  };
  refused(json, ":2: rho: is 1, expected 0...0");
  const std::vector<JsonFile> points = json.objects("points");
  REQUIRE(points.size() == 2);
  refused(points[0], ":4: points[0].rho: is 2, expected 0...0");
  refused(points[0].object("in"), ":5: points[0].in.rho: is 3, expected 0...0");
  refused(points[1].object("in").objects("x").at(0), ":6: points[1].in.x[0].rho: is 4, expected 0...0");
  refused(points[1].object("in"), ":7: points[1].in.rho: is 5, expected 0...0");
  refused(points[1], ":7: points[1].rho: is 6, expected 0...0");
  CHECK(complaint([&] { json.fail(InvalidField("", "points[1].in.rho", "is 5, expected less")); }) ==
        file.string() + ":7: points[1].in.rho: is 5, expected less");
}

TEST_CASE("a key that an object lacks is missed where that object begins, whoever else has it") {
  TemporaryFolder folder;
  const auto file =
      folder.write("a.json", "{\n\"points\": [\n{\"x\": {\"rho\": 1}},\n{\"rho\": 2}],\n\"rho\": 3}");
  const std::vector<JsonFile> points = JsonFile(file).objects("points");
  REQUIRE(points.size() == 2);
  CHECK(complaint([&] {
          points[0].number("rho", {0, 9});
        }).rfind(file.string() + ":3: points[0].rho: ", 0) == 0);
  CHECK(points[1].number("rho", {0, 9}) == 2);
}

TEST_CASE("a file nested deeper than 32 levels is refused in one line, whatever its size") {
  TemporaryFolder folder;
  const auto said = [&](int levels) {
    const auto file =
        folder.write("a.json", "{\n\"x\":" + repeated("[", levels) + repeated("]", levels) + "}");
    return complaint([&] { const JsonFile json(file); });
  };
  CHECK(said(31) == "");
  CHECK(said(32) == (folder.path / "a.json").string() +
                        ":2: has brackets more than 32 levels deep, expected a file that rigsound writes");
  CHECK(said(300000).find(":2: has brackets more than 32 levels deep") != std::string::npos);
}

TEST_CASE("lists longer than any model has, and files larger, are refused") {
  TemporaryFolder folder;
  const auto file =
      folder.write("a.json", "{\"objects\": [{}" + repeated(",{}", 1024) + "], \"numbers\": [1" +
                                 repeated(",1", 1 << 20) + "], \"pairs\": [[1, 2], [3, 4]]}");
  const JsonFile json(file);
  CHECK(complaint([&] { json.objects("objects"); }) ==
        file.string() + ":1: objects: is a list of 1025, expected at most 1024 objects");
  CHECK(complaint([&] {
          json.floats("numbers", {0, 1});
        }) == file.string() + ":1: numbers: is a list of 1048577, expected at most 1048576 numbers");
  CHECK(complaint([&] {
          json.pairs("pairs", {0, 9}, 1);
        }) == file.string() + ":1: pairs: is a list of 2, expected at most 1 pairs [b, c] of numbers, 0...9");
  folder.write("a.json", "{}" + std::string(16 << 20, ' '));
  CHECK(complaint([&] { const JsonFile large(file); }) ==
        file.string() + ": is of 17 MiB, expected a model of at most 16 MiB");
}

TEST_CASE("a list may be as long as its reader says") {
  const TemporaryFolder folder;
  const JsonFile json(folder.write(
      "a.json", "{\"pairs\": [[1, 2], [3, 4]], \"objects\": [{}" + repeated(",{}", 1023) + "]}"));
  const auto pairs = json.pairs("pairs", {0, 9}, 2);
  REQUIRE(pairs.size() == 2);
  CHECK((pairs[1][0] == 3 && pairs[1][1] == 4));
  CHECK(json.objects("objects").size() == 1024);
}

TEST_CASE("a pair is a list of two numbers in their range") {
  const TemporaryFolder folder;
  const auto said = [&](const char* pair) {
    const JsonFile json(folder.write("a.json", "{\"x\": [[1, 2], " + std::string(pair) + "]}"));
    return complaint([&] { json.pairs("x", {0, 9}, 3); });
  };
  CHECK(said("[0, 9]").empty());
  for (const char* other : {"1", "{}", "{\"a\": 1, \"b\": 2}", "\"ab\"", "[]", "[1]", "[1, 2, 3]",
                            "[\"a\", 2]", "[1, \"b\"]", "[1, null]"}) {
    CAPTURE(other);
    CHECK(said(other).find("x: holds something else, expected at most 3 pairs [b, c]") != std::string::npos);
  }
  CHECK(said("[10, 2]").find("x: is 10, expected 0...9") != std::string::npos);
  CHECK(said("[1, -1]").find("x: is -1, expected 0...9") != std::string::npos);
}

TEST_CASE("messages name a wrong value's kind and never print what it holds") {
  TemporaryFolder folder;
  const std::string big = repeated("[1,", 20) + "1" + repeated("]", 20);
  const auto file = folder.write("a.json", "{\"a\": [" + big + "], \"b\": {\"c\": " + big + "}}");
  const JsonFile json(file);
  CHECK(complaint([&] {
          json.floats("a", {0, 1});
        }) == file.string() + ":1: a: holds a list, expected numbers, 0...1");
  CHECK(complaint([&] {
          json.number("b", {0, 1});
        }) == file.string() + ":1: b: is an object, expected a number, 0...1");
  CHECK(complaint([&] {
          json.pairs("a", {0, 1}, 3);
        }) ==
        file.string() + ":1: a: holds something else, expected at most 3 pairs [b, c] of numbers, 0...1");
  CHECK(complaint([&] { json.object("a"); }) == file.string() + ":1: a: is a list, expected an object { }");
}

TEST_CASE("a key that stands twice does no harm") {
  TemporaryFolder folder;
  const JsonFile json(folder.write("a.json", "{\"x\": [{}], \"x\": [{\"y\": 1}, {\"y\": 2}]}"));
  REQUIRE(json.objects("x").size() == 2);
  CHECK(json.objects("x")[1].number("y", {0, 9}) == 2);
}
