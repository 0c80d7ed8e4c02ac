#include "chart/style_sheet.hpp"

#include <fmt/format.h>

#include "chart/paint.hpp"

namespace rigsound::chart {
namespace {

constexpr const char* kMedia[kThemeCount] = {"", "@media (prefers-color-scheme: dark) ", "@media print "};

/// `rule(role, colour)` for every role, theme by theme; later ones win.
template <class Rule>
std::string for_every_theme(const char* open, const char* close, Rule rule) {
  std::string css;
  for (int t = 0; t < kThemeCount; ++t) {
    std::string rules;
    for (int r = 0; r < kRoleCount; ++r) {
      const Role role = static_cast<Role>(r);
      rules += rule(name(role), hex(colour(role, static_cast<Theme>(t))));
    }
    css += t == 0 ? fmt::format("{}{}{}\n", open, rules, close)
                  : fmt::format("{}{{ {}{}{} }}\n", kMedia[t], open, rules, close);
  }
  return css;
}

}  // namespace

std::string page_colours() {
  return ":root { color-scheme: light dark }\n" +
         for_every_theme(":root { ", "}", [](const char* role, const std::string& colour) {
           return fmt::format("--{}: {}; ", role, colour);
         });
}

std::string chart_styles() {
  return "svg path{fill:none}svg image{image-rendering:pixelated}"
         "svg text{font-family:system-ui,\"DejaVu Sans\",sans-serif}\n" +
         for_every_theme("", "", [](const char* role, const std::string& colour) {
           return fmt::format(".s{0}{{stroke:{1}}}.f{0}{{fill:{1}}}", role, colour);
         });
}

}  // namespace rigsound::chart
