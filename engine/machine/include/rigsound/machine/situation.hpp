// The five drilling situations of the drilling paper (section 1).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rigsound {

enum class Situation : std::uint8_t { kNormal, kUnderfeed, kOverfeed, kClosedRattling, kOpenRattling };
constexpr int kSituationCount = 5;

constexpr std::array<std::string_view, kSituationCount> kSituationNames = {
    "normal", "underfeed", "overfeed", "closed_rattling", "open_rattling"};

constexpr std::string_view name(Situation s) { return kSituationNames[static_cast<std::size_t>(s)]; }

constexpr std::optional<Situation> situation_by_name(std::string_view text) {
  for (int i = 0; i < kSituationCount; ++i)
    if (kSituationNames[static_cast<std::size_t>(i)] == text) return static_cast<Situation>(i);
  return std::nullopt;
}

}  // namespace rigsound
