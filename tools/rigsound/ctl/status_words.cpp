#include "ctl/status_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "rigsound/machine/signal.hpp"

namespace rigsound::tools {
namespace {

constexpr double kBarFloor_db = -60, kSilent_db = -140;

// Short enough for a column of the watch.
constexpr std::pair<std::string_view, std::string_view> kMarks[] = {{"valid", ""},
                                                                    {"never_seen", ""},
                                                                    {"bus_down", "down"},
                                                                    {"error_value", "error"},
                                                                    {"not_available", "n/a"},
                                                                    {"out_of_range", "range"}};

}  // namespace

std::string bar_of(double db, int width) {
  const double share = std::clamp((db - kBarFloor_db) / -kBarFloor_db, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(share * width + 0.5);
  return std::string(filled, '#') + std::string(static_cast<std::size_t>(width) - filled, '.');
}

std::string db_text(double db) { return db > kSilent_db ? fmt::format("{:.1f}", db) : "silent"; }

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::max(0.0, seconds));
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string value_text(const Json& signal) {
  const std::string word = signal["word"];
  return word.empty() ? fmt::format("{:.5g}", signal["value"].get<double>()) : word;
}

std::string_view mark_of(const Json& signal) {
  const auto& validity = signal["validity"].get_ref<const std::string&>();
  for (const auto& [known, mark] : kMarks)
    if (known == validity) return mark;
  return validity;
}

bool is_told(const Json& signal) { return !signal["age_s"].is_null() || signal["validity"] == "manual"; }

std::string asked_and_got(const Json& boom) {
  std::string rods = std::to_string(boom["rods"].get<int>());
  std::string rock = boom["rock"];
  if (!boom["banks"].empty()) {
    const Json& bank = boom["banks"].front();
    if (bank["rods"] != 0 && bank["rods"] != boom["rods"])
      rods += ">" + std::to_string(bank["rods"].get<int>());
    if (bank["rock"] != "" && bank["rock"] != boom["rock"]) rock += ">" + bank["rock"].get<std::string>();
  }
  return rods + " / " + rock;
}

std::string refused_text(const Json& signal) {
  const std::uint64_t refused = signal["refused"], clamped = signal["clamped"];
  std::string text;
  if (refused > 0) text = fmt::format("{} refused", refused);
  if (!signal["last_refused"].is_null())
    text += fmt::format(", last {:g}", signal["last_refused"].get<double>());
  if (clamped > 0) text += fmt::format("{}{} clamped", text.empty() ? "" : ", ", clamped);
  return text;
}

std::string controls_text(const Json& boom) {
  std::string text;
  for (const ControlInfo& control : control_table()) {
    const double value = boom[std::string(control.name)];
    if (value == control.neutral) continue;
    text += fmt::format("{}{} {:g}{}{}", text.empty() ? "" : ", ", control.name, value,
                        control.unit.empty() ? "" : " ", control.unit);
  }
  return text;
}

}  // namespace rigsound::tools
