#include "dbc/dbc_cursor.hpp"

#include <algorithm>

#include "rigsound/machine/input_error.hpp"
#include "rigsound/number_of.hpp"
#include "text/utf8.hpp"

namespace rigsound::config {

const DbcToken& DbcCursor::peek(std::size_t ahead) const {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

DbcToken DbcCursor::take() {
  const DbcToken token = peek();
  ++at_;  // peek() stays at the end
  return token;
}

bool DbcCursor::take_sign(char c) {
  if (!at_sign(c)) return false;
  take();
  return true;
}

void DbcCursor::expect_sign(char c) {
  if (!take_sign(c)) fail_expected(std::string("'") + c + "'");
}

std::string DbcCursor::expect_word(std::string_view what) {
  if (!at_word()) fail_expected(what);
  return std::string(take().text);
}

std::string DbcCursor::expect_string(std::string_view what) {
  if (!at_string()) fail_expected(what);
  std::string text;
  const std::string_view raw = take().text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw.substr(i, 2) == "\\\"") ++i;
    text += raw[i];
  }
  return to_utf8(text);
}

double DbcCursor::expect_number(std::string_view what) {
  if (!at_number()) fail_expected(what);
  std::string_view text = peek().text;
  if (text.front() == '+') text.remove_prefix(1);
  const auto x = number_of<double>(text);
  if (!x) fail_expected(what);
  take();
  return *x;
}

std::int64_t DbcCursor::expect_integer(std::string_view what, std::int64_t min, std::int64_t max) {
  if (!at_number()) fail_expected(what);
  std::string_view text = peek().text;
  if (text.front() == '+') text.remove_prefix(1);
  const auto n = number_of<std::int64_t>(text);
  if (!n || *n < min || *n > max)
    fail_expected(std::string(what) + " from " + std::to_string(min) + " to " + std::to_string(max));
  take();
  return *n;
}

void DbcCursor::fail(std::string_view message) const {
  throw InputError(file_, peek().line, section_, message);
}

void DbcCursor::fail_expected(std::string_view what) const {
  const DbcToken& token = peek();
  const std::string found = token.kind == DbcToken::Kind::kEnd
                                ? "the file ends"
                                : "found '" + to_utf8(token.text.substr(0, 40)) + "'";
  fail(found + ", expected " + std::string(what));
}

}  // namespace rigsound::config
