// Walks over DBC tokens; every step says what it expected and where.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dbc/dbc_tokens.hpp"

namespace rigsound::config {

class DbcCursor {
 public:
  DbcCursor(std::vector<DbcToken> tokens, const std::string& file)
      : tokens_(std::move(tokens)), file_(file) {}

  const DbcToken& peek(std::size_t ahead = 0) const;
  bool at_end() const { return peek().kind == DbcToken::Kind::kEnd; }
  bool at_word() const { return peek().kind == DbcToken::Kind::kWord; }
  bool at_number() const { return peek().kind == DbcToken::Kind::kNumber; }
  bool at_string() const { return peek().kind == DbcToken::Kind::kString; }
  bool at_sign(char c) const { return peek().kind == DbcToken::Kind::kSign && peek().text.front() == c; }

  DbcToken take();
  bool take_sign(char c);  ///< false, and nothing taken, when another token stands here
  void expect_sign(char c);
  std::string expect_word(std::string_view what);
  std::string expect_string(std::string_view what);  ///< UTF-8, escapes resolved
  double expect_number(std::string_view what);
  std::int64_t expect_integer(std::string_view what, std::int64_t min, std::int64_t max);

  /// The section that messages name from here on.
  void enter(std::string_view section) { section_ = section; }

  [[noreturn]] void fail(std::string_view message) const;
  [[noreturn]] void fail_expected(std::string_view what) const;

 private:
  std::vector<DbcToken> tokens_;
  std::size_t at_ = 0;
  const std::string& file_;
  std::string_view section_;
};

}  // namespace rigsound::config
