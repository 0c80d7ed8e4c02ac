// DBC text cut into tokens.
#include "dbc/dbc_tokens.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "dbc/dbc_codes.hpp"

using namespace rigsound;
using config::DbcToken;

namespace {

/// Every token with a letter for its kind, and a stroke before the first of a line.
std::string cut(std::string_view text) {
  std::string out;
  for (const DbcToken& token : config::dbc_tokens(text)) {
    if (!out.empty()) out += ' ';
    if (token.first_in_line) out += '|';
    out += "wnsg."[static_cast<int>(token.kind)];
    out += token.text;
  }
  return out;
}

std::vector<int> lines(std::string_view text) {
  std::vector<int> found;
  for (const DbcToken& token : config::dbc_tokens(text)) found.push_back(token.line);
  return found;
}

}  // namespace

TEST_CASE("words are letters, digits, underscores and whatever is no ASCII") {
  CHECK(cut("azAZ_09") == "|wazAZ_09 .");
  CHECK(cut("_x") == "|w_x .");
  CHECK(cut("\xC3\xA4\x80\xFF") == "|w\xC3\xA4\x80\xFF .");
  CHECK(cut("a@b`c[d{e/f:g") == "|wa g@ wb g` wc g[ wd g{ we g/ wf g: wg .");
}

TEST_CASE("every kind of white space parts tokens, a line's first token is marked") {
  CHECK(cut("a b\tc\rd\ve\ff") == "|wa wb wc wd we wf .");
  CHECK(cut("a\nb c\r\n\n d") == "|wa |wb wc |wd .");
  CHECK(cut("  a") == "|wa .");
  CHECK(cut("") == "|.");
  CHECK(lines("a\nb c\n\nd") == std::vector<int>{1, 2, 2, 4, 4});
}

TEST_CASE("a comment reaches to the end of its line, a lone slash is a sign") {
  CHECK(cut("a // b c\nd") == "|wa |wd .");
  CHECK(cut("a //") == "|wa .");
  CHECK(cut("a / b") == "|wa g/ wb .");
  CHECK(lines("a // b\nc") == std::vector<int>{1, 2, 2});
}

TEST_CASE("numbers with signs, decimals and exponents") {
  for (const char* number :
       {"0", "9", "12", "-5", "+5", "1.5", ".5", "-.5", "1e3", "1E3", "1e-3", "1e+3", "2.5e10", "1."})
    CHECK(cut(number) == "|n" + std::string(number) + " .");
  CHECK(cut("1e") == "|n1 we .");
  CHECK(cut("1e-") == "|n1 we g- .");
  CHECK(cut("1x") == "|n1 wx .");
  CHECK(cut(".") == "|g. .");
  CHECK(cut("-") == "|g- .");
  CHECK(cut("-x") == "|g- wx .");
  CHECK(cut("+.") == "|g+ g. .");
  CHECK(cut("(1,-5)") == "|g( n1 g, n-5 g) .");
}

TEST_CASE("a dash right behind a word or a number is a range, not a minus") {
  CHECK(cut("3-5") == "|n3 g- n5 .");
  CHECK(cut("a-5") == "|wa g- n5 .");
  CHECK(cut("a -5") == "|wa n-5 .");
}

TEST_CASE("strings keep their escapes, may go over lines, and count them") {
  CHECK(cut(R"("a b" c)") == "|sa b wc .");
  CHECK(cut(R"("say \"x\" y" c)") == "|ssay \\\"x\\\" y wc .");
  CHECK(cut(R"("a\b" c)") == "|sa\\b wc .");
  CHECK(cut(R"("a\" c)") == "|sa\\\" c .");  // it never ends
  CHECK(cut("\"\"") == "|s .");
  CHECK(lines("\"a\nb\" c\nd") == std::vector<int>{1, 2, 3, 3});
}

TEST_CASE("where a quote is missing a string ends before the next section, else it may hold one") {
  CHECK(cut("CM_ \"open;\nBO_ 1") == "|wCM_ g\" |wBO_ n1 .");
  CHECK(cut("CM_ \"open;\n \t BO_ 1") == "|wCM_ g\" |wBO_ n1 .");
  CHECK(cut("CM_ \"open;\nthing 1") == "|wCM_ sopen;\nthing 1 .");
  CHECK(cut("CM_ \"whole\nBO_ 1\";") == "|wCM_ swhole\nBO_ 1 g; .");
  CHECK(cut("CM_ \"an \\\" escape\nBO_ 1\";") == "|wCM_ san \\\" escape\nBO_ 1 g; .");
}

TEST_CASE("a text ends where its view ends, and begins where it begins") {
  const auto first = [](std::string_view text, std::size_t letters) { return cut(text.substr(0, letters)); };
  CHECK(first("12345", 2) == "|n12 .");
  CHECK(first("1e55", 3) == "|n1e5 .");
  CHECK(first("1e55", 2) == "|n1 we .");
  CHECK(first("-5", 1) == "|g- .");
  CHECK(first("abc", 2) == "|wab .");
  CHECK(first("a \n b", 1) == "|wa .");
  CHECK(first("a \n b", 2) == "|wa .");
  CHECK(first("a //b\nc", 3) == "|wa g/ .");
  CHECK(first("a //b\nc", 5) == "|wa .");
  CHECK(first("\"ab\" c", 3) == "|sab .");
  CHECK(first("\"a\\\" c", 3) == "|sa\\ .");
  CHECK(first("\"a\" \"\nBO_ 1", 3) == "|sa .");
  CHECK(first("CM_ \"a\nBO_", 9) == "|wCM_ sa\nBO .");
  CHECK(first("CM_ \"a\nCM_X", 10) == "|wCM_ g\" |wCM_ .");
  CHECK(first("CM_ \"a\nBO_ \"", 11) == "|wCM_ g\" |wBO_ .");
  CHECK(cut(std::string_view("a-5").substr(1)) == "|n-5 .");
}

TEST_CASE("a byte order mark is no token") {
  CHECK(cut("\xEF\xBB\xBF"
            "a") == "|wa .");
}

TEST_CASE("texts of raw values say which are none") {
  const auto meaning = [](const std::string& text) {
    config::DbcSignal signal;
    signal.layout.field.length = 8;
    signal.values[0] = text;
    return config::raw_codes(signal).front().meaning;
  };
  for (const char* text : {"Not available", "SNA", "Signal not available", "N/A", "na", "Unavailable",
                           "Don't care", "Do not care", "Take no action", "NOT INSTALLED"})
    CHECK_MESSAGE(meaning(text) == Validity::kNotAvailable, text);
  for (const char* text : {"Error", "Fault 3", "Invalid", "not valid", "Reserved", "undefined",
                           "Sensor error", "Bus fault", "Data invalid", "ERROR"})
    CHECK_MESSAGE(meaning(text) == Validity::kErrorValue, text);
  for (const char* text : {"on", "", "No error", "No fault", "nap", "an error occurred here", "available",
                           "valid", "Zebra", "azAZ"})
    CHECK_MESSAGE(meaning(text) == Validity::kValid, text);
}

TEST_CASE("raw values of texts are those of the signal's bits") {
  config::DbcSignal signal;
  const auto raw = [&](int length, std::int64_t value) {
    signal.layout.field.length = length;
    signal.values = {{value, "x"}};
    return config::raw_codes(signal).front().raw;
  };
  CHECK(raw(8, -1) == 0xFF);
  CHECK(raw(4, -1) == 0xF);
  CHECK(raw(8, 0x1FF) == 0xFF);
  CHECK(raw(63, -1) == 0x7FFFFFFFFFFFFFFF);
  CHECK(raw(64, -1) == 0xFFFFFFFFFFFFFFFF);
}
