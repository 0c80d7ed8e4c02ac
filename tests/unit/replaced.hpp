// A text with one place of it changed.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace rigsound::test {

/// `text` with `to` where `from` stands first, which has to be there.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace rigsound::test
