#include "chart/paint.hpp"

#include <fmt/format.h>

namespace rigsound::chart {
namespace {

struct RoleColours {
  const char* name;
  std::array<Colour, kThemeCount> of_theme;  // light, dark, print
};

constexpr Colour rgb(std::uint32_t code) {
  return {static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 8 & 0xff),
          static_cast<std::uint8_t>(code & 0xff)};
}

constexpr std::array<RoleColours, kRoleCount> kRoles = {{
    {"ink", {rgb(0x1b1b1f), rgb(0xe8e8ec), rgb(0x000000)}},
    {"paper", {rgb(0xffffff), rgb(0x17171b), rgb(0xffffff)}},
    {"grey", {rgb(0x6b6b74), rgb(0xa2a2ac), rgb(0x555555)}},
    {"faint", {rgb(0xdcdce2), rgb(0x3a3a42), rgb(0xcccccc)}},
    {"first", {rgb(0x1f66b0), rgb(0x6db1ff), rgb(0x1f66b0)}},
    {"second", {rgb(0xa9adb8), rgb(0x6a6d79), rgb(0xa9adb8)}},
    {"third", {rgb(0xc2410c), rgb(0xff9a5c), rgb(0xc2410c)}},
    {"onset", {rgb(0x15803d), rgb(0x5bd68a), rgb(0x15803d)}},
    {"warn", {rgb(0x9a4a06), rgb(0xf5b04c), rgb(0x8a4207)}},
}};

}  // namespace

std::string hex(Colour c) { return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue); }

const char* name(Role role) { return kRoles[static_cast<std::size_t>(role)].name; }

Colour colour(Role role, Theme theme) {
  return kRoles[static_cast<std::size_t>(role)].of_theme[static_cast<std::size_t>(theme)];
}

}  // namespace rigsound::chart
