#include "rig/sections.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {

// SIGNAL = "idle", or SIGNAL = { action = "idle", stale_after_ms = 300 }.
SafetyOptions read_safety(TomlTable table, const StaleDefaults& stale) {
  SafetyOptions safety;
  read(table, safety);
  const bool one_limit = table.has("stale_after_ms");
  const double limit_ms = table.number("stale_after_ms", 0, toml_range(kStaleAges));
  for (int i = 0; i < kSignalCount; ++i) {
    const auto s = static_cast<Signal>(i);
    const std::string_view key = info(s).name;
    SafetyRule& rule = safety.rule[static_cast<std::size_t>(i)];
    rule.action = info(s).action;
    rule.stale_after_s = one_limit ? limit_ms / 1000 : stale[static_cast<std::size_t>(i)];
    if (!table.is_table(key)) {
      rule.action = table.word(key, rule.action, kSafetyActions);
      continue;
    }
    TomlTable details = table.table(key);
    read(details, rule);
    details.refuse_unknown();
  }
  table.refuse_unknown();
  return safety;
}

}  // namespace rigsound::config
