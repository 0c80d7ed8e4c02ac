#include <algorithm>

#include "rig/sections.hpp"
#include "rigsound/config/nearest_word.hpp"

namespace rigsound::config {
namespace {

using Each = std::function<void(TomlTable&, const std::string&, SignalId)>;

[[noreturn]] void refuse(const TomlTable& table, const std::string& key,
                         const std::vector<BoomOptions>& booms) {
  std::vector<std::string> known;
  for (const SignalInfo& signal : signal_table()) known.emplace_back(signal.name);
  for (const BoomOptions& boom : booms) known.push_back(boom.name);
  const std::string_view near = nearest_word(key, known);
  table.fail(key, "is no machine signal" + (near.empty()
                                                ? " and no boom, expected engine_rpm, feed_pressure_bar, ..."
                                                : ", did you mean '" + std::string(near) + "'?"));
}

void read_boom(TomlTable table, const std::vector<BoomOptions>& booms, std::uint8_t boom, const Each& each) {
  for (const std::string& key : table.keys()) {
    const auto signal = signal_by_name(key);
    if (!signal) refuse(table, key, booms);
    if (!info(*signal).per_boom)
      table.fail(key, "is a signal of the whole rig, expected it outside the boom's table");
    each(table, key, {*signal, boom});
  }
}

}  // namespace

void read_signals(TomlTable table, const std::vector<BoomOptions>& booms, const Each& each) {
  for (const std::string& key : table.keys()) {
    const auto boom = std::find_if(booms.begin(), booms.end(),
                                   [&](const BoomOptions& options) { return options.name == key; });
    if (const auto signal = signal_by_name(key))
      each(table, key, {*signal, 0});
    else if (boom != booms.end())
      read_boom(table.table(key), booms, static_cast<std::uint8_t>(boom - booms.begin()), each);
    else
      refuse(table, key, booms);
  }
}

}  // namespace rigsound::config
