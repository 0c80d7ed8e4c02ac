#include "rigsound/config/nearest_word.hpp"

#include <doctest/doctest.h>

#include <string>

using rigsound::config::edit_distance;
using rigsound::config::nearest_word;

TEST_CASE("a letter too many, too few, another one or two swapped are one edit each") {
  for (const char* slip : {"decodee", "decde", "dedode", "dceode", "ecode", "decoed"})
    CHECK_MESSAGE(edit_distance(slip, "decode") == 1, slip);
  CHECK(edit_distance("decode", "decode") == 0);
  CHECK(edit_distance("", "log") == 3);
  CHECK(edit_distance("log", "") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ca", "abc") == 3);  // no edit inside a swap
  CHECK(edit_distance("abcd", "badc") == 2);
}

TEST_CASE("the swap decides between two words that were as near") {
  const std::vector<std::string> words = {"form", "from"};
  CHECK(nearest_word("fomr", words) == "form");
  CHECK(nearest_word("fro", words) == "from");
  CHECK(nearest_word("xylophone", words).empty());
}
