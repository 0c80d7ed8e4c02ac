// Names that become files and folders of a sound set.
#pragma once

#include <string_view>

namespace rigsound::config {

constexpr std::string_view kNameRule =
    "expected 1 to 100 letters, digits, '_', '-' or '.', not starting with '.'";

/// True for a name that cannot leave its folder.
constexpr bool is_name(std::string_view text) {
  if (text.empty() || text.size() > 100 || text.front() == '.') return false;
  for (const char c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!letter && c != '_' && c != '-' && c != '.') return false;
  }
  return true;
}

}  // namespace rigsound::config
