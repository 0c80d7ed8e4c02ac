// Text that may hold anything, made safe for HTML.
#pragma once

#include <string>
#include <string_view>

namespace rigsound::analysis {

inline std::string html_text(std::string_view text) {
  std::string safe;
  for (const char c : text) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  return safe;
}

}  // namespace rigsound::analysis
