#include "rig/sections.hpp"

namespace rigsound::config {
namespace {

constexpr Word<SafetyAction> kActions[] = {
    {"hold", SafetyAction::kHold}, {"idle", SafetyAction::kIdle}, {"mute", SafetyAction::kMute}};
constexpr double kMaxMs = 3600000;

}  // namespace

// SIGNAL = "idle", or SIGNAL = { action = "idle", stale_after_ms = 300 }.
SafetyOptions read_safety(TomlTable table, const StaleDefaults& stale) {
  SafetyOptions safety;
  safety.fade_s = table.number("fade_ms", safety.fade_s * 1000, 0, 60000) / 1000;
  const bool one_limit = table.has("stale_after_ms");
  const double limit_ms = table.number("stale_after_ms", 0, 0, kMaxMs);
  for (int i = 0; i < kSignalCount; ++i) {
    const auto s = static_cast<Signal>(i);
    const std::string_view key = info(s).name;
    SafetyRule& rule = safety.rule[static_cast<std::size_t>(i)];
    rule.action = info(s).action;
    rule.stale_after_s = one_limit ? limit_ms / 1000 : stale[static_cast<std::size_t>(i)];
    if (!table.is_table(key)) {
      rule.action = table.word(key, rule.action, kActions);
      continue;
    }
    TomlTable details = table.table(key);
    rule.action = details.word("action", rule.action, kActions);
    rule.stale_after_s = details.number("stale_after_ms", rule.stale_after_s * 1000, 0, kMaxMs) / 1000;
    details.refuse_unknown();
  }
  table.refuse_unknown();
  return safety;
}

}  // namespace rigsound::config
