// Text that may hold anything, made safe for HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace rigsound::chart {

inline std::string markup_text(std::string_view text) {
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

}  // namespace rigsound::chart
