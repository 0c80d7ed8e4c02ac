// DBC text cut into words, numbers, strings and signs. White space and newlines may stand anywhere.
#pragma once

#include <string_view>
#include <vector>

namespace rigsound::config {

struct DbcToken {
  enum class Kind { kWord, kNumber, kString, kSign, kEnd };
  Kind kind = Kind::kEnd;
  std::string_view text;  ///< of a string: without its quotes, escapes still in it
  int line = 1;
  bool first_in_line = false;
};

/// The last token is kEnd. Views point into `text`. In a text that lacks a quote somewhere no string reaches
/// over the beginning of a section: the open quote is a sign.
std::vector<DbcToken> dbc_tokens(std::string_view text);

}  // namespace rigsound::config
