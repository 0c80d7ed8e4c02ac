#include "rig/units.hpp"

#include <algorithm>
#include <iterator>
#include <string>

namespace rigsound::config {
namespace {

struct Named {
  std::string_view name;
  Unit unit;
};

constexpr Named kUnits[] = {
    {"bar", {Quantity::kPressure, 1}},
    {"bara", {Quantity::kPressure, 1}},
    {"barg", {Quantity::kPressure, 1}},
    {"mbar", {Quantity::kPressure, 1e-3}},
    {"hpa", {Quantity::kPressure, 1e-3}},
    {"pa", {Quantity::kPressure, 1e-5}},
    {"kpa", {Quantity::kPressure, 1e-2}},
    {"mpa", {Quantity::kPressure, 10}},
    {"psi", {Quantity::kPressure, 0.0689475729}},
    {"kg/cm2", {Quantity::kPressure, 0.980665}},
    {"kgf/cm2", {Quantity::kPressure, 0.980665}},
    {"hz", {Quantity::kFrequency, 1}},
    {"khz", {Quantity::kFrequency, 1e3}},
    {"1/s", {Quantity::kFrequency, 1}},
    {"r/s", {Quantity::kFrequency, 1}},
    {"rev/s", {Quantity::kFrequency, 1}},
    {"rps", {Quantity::kFrequency, 1}},
    {"r/min", {Quantity::kFrequency, 1.0 / 60}},
    {"rev/min", {Quantity::kFrequency, 1.0 / 60}},
    {"rpm", {Quantity::kFrequency, 1.0 / 60}},
    {"u/min", {Quantity::kFrequency, 1.0 / 60}},
    {"1/min", {Quantity::kFrequency, 1.0 / 60}},
    {"min-1", {Quantity::kFrequency, 1.0 / 60}},
    {"min^-1", {Quantity::kFrequency, 1.0 / 60}},
    {"bpm", {Quantity::kFrequency, 1.0 / 60}},
    {"rad/s", {Quantity::kFrequency, 0.15915494}},
    {"%", {Quantity::kRatio, 1e-2}},
    {"percent", {Quantity::kRatio, 1e-2}},
    {"m", {Quantity::kLength, 1}},
    {"cm", {Quantity::kLength, 1e-2}},
    {"mm", {Quantity::kLength, 1e-3}},
    {"ft", {Quantity::kLength, 0.3048}},
    {"in", {Quantity::kLength, 0.0254}},
    {"db", {Quantity::kLevel, 1}},
};

constexpr std::string_view kOthers[] = {"c", "k",   "f",     "degc", "degf", "deg",  "rad", "v",     "mv",
                                        "a", "ma",  "w",     "kw",   "n",    "kn",   "nm",  "kg",    "g",
                                        "l", "l/h", "l/min", "l/s",  "m3/h", "km/h", "m/s", "m/min", "m/s2",
                                        "s", "ms",  "min",   "h",    "ohm",  "j",    "kj",  "km",    "t"};

std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ' || byte >= 0x80) continue;
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

}  // namespace

std::optional<Unit> unit_of(std::string_view text) {
  const std::string name = plain(text);
  const auto known = std::find_if(std::begin(kUnits), std::end(kUnits),
                                  [&](const Named& named) { return named.name == name; });
  if (known != std::end(kUnits)) return known->unit;
  if (std::find(std::begin(kOthers), std::end(kOthers), name) != std::end(kOthers)) return Unit{};
  return std::nullopt;
}

}  // namespace rigsound::config
