// What a chart is coloured with: roles that every theme has its own colour for, or one fixed colour.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace rigsound::chart {

struct Colour {
  std::uint8_t red, green, blue;
};

/// "#1f66b0".
std::string hex(Colour colour);

enum class Role : std::uint8_t { kInk, kPaper, kGrey, kFaint, kFirst, kSecond, kThird, kOnset, kWarn };
constexpr int kRoleCount = 9;

enum class Theme : std::uint8_t { kLight, kDark, kPrint };
constexpr int kThemeCount = 3;

/// Name in style sheets. Thread: any.
const char* name(Role role);
Colour colour(Role role, Theme theme);

struct Paint {
  Paint(Role r, double o = 1) : role(r), opacity(o) {}
  Paint(Colour c, double o = 1) : fixed(c), opacity(o) {}

  Role role = Role::kInk;
  std::optional<Colour> fixed;  ///< the same in every theme, instead of the role
  double opacity;               ///< 0...1
};

}  // namespace rigsound::chart
