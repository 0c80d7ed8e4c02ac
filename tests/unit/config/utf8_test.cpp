// Texts of files: UTF-8 as it is, anything else as Windows-1252.
#include "text/utf8.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace rigsound;

TEST_CASE("UTF-8 of every length is left as it is") {
  for (const char* text : {"", "plain ~", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xEF\xBF\xBD",
                           "\xF0\x9F\x94\xA7", "\xF4\x8F\xBF\xBF", "a\xC3\xA4z"})
    CHECK(config::to_utf8(text) == text);
}

TEST_CASE("what is no UTF-8 is read as Windows-1252, byte by byte") {
  CHECK(config::to_utf8("\x80") == "\xE2\x82\xAC");
  CHECK(config::to_utf8("\x9F") == "\xC5\xB8");
  CHECK(config::to_utf8("\xA0") == "\xC2\xA0");
  CHECK(config::to_utf8("\xFF") == "\xC3\xBF");
  CHECK(config::to_utf8("5 \xB0\x43") == "5 \xC2\xB0\x43");
  CHECK(config::to_utf8("\x81") == "\xEF\xBF\xBD");              // stands for nothing
  CHECK(config::to_utf8("\xC0\x80") == "\xC3\x80\xE2\x82\xAC");  // no sequence begins so
  CHECK(config::to_utf8("\xC1\xBF") == "\xC3\x81\xC2\xBF");
  CHECK(config::to_utf8("\xF5\x80\x80\x80") == "\xC3\xB5\xE2\x82\xAC\xE2\x82\xAC\xE2\x82\xAC");
  CHECK(config::to_utf8("\xE2\x82") == "\xC3\xA2\xE2\x80\x9A");  // cut off
  CHECK(config::to_utf8("\xC3") == "\xC3\x83");
  CHECK(config::to_utf8("\xE2\x82x") == "\xC3\xA2\xE2\x80\x9Ax");  // the third byte does not go on
  CHECK(config::to_utf8("\xC3x\xA4") == "\xC3\x83x\xC2\xA4");
}
