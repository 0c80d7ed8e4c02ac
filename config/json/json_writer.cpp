#include "json/json_writer.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/config/json.hpp"

namespace rigsound::config {
namespace {

double rounded(double x, const Range& range) {
  if (range.decimals < 0) return x;
  const double scale = std::pow(10.0, range.decimals);
  return std::round(x * scale) / scale;
}

/// `per_decade` is 10 for powers, 20 for amplitudes.
double level(double x, double per_decade, const Range& levels) {
  return rounded(x > 0 ? std::max(levels.min, per_decade * std::log10(x)) : levels.min, levels);
}

void append(const Json& json, int depth, std::string& text) {
  const bool nested = json.is_array() && !json.empty() && json.front().is_object();
  if (!json.is_object() && !nested) {
    text += json_line(json);
    return;
  }
  const std::string indent(static_cast<std::size_t>(2 * depth + 2), ' ');
  text += nested ? "[\n" : "{\n";
  std::size_t left = json.size();
  for (const auto& [key, value] : json.items()) {
    text += indent;
    if (!nested) text += json_line(key) + ": ";
    append(value, depth + 1, text);
    text += --left ? ",\n" : "\n";
  }
  text += std::string(static_cast<std::size_t>(2 * depth), ' ') + (nested ? "]" : "}");
}

}  // namespace

Json& JsonWriter::child(const char* key, Kind kind) {
  return out_[key] = kind == Kind::kList ? Json::array() : Json::object();
}

Json& JsonWriter::next_item(Json& list) { return list.emplace_back(Json::object()); }

void JsonWriter::operator()(const char* key, const double& x, const Range& range) {
  out_[key] = rounded(x, range);
}

void JsonWriter::operator()(const char* key, const int& x, const Range&) { out_[key] = x; }
void JsonWriter::operator()(const char* key, const bool& on) { out_[key] = on; }
void JsonWriter::operator()(const char* key, const std::string& text) { out_[key] = text; }

void JsonWriter::operator()(const char* key, const Allpass& allpass, const Range&) {
  Json& sections = out_[key]["sections"] = Json::array();
  for (int i = 0; i < allpass.sections; ++i) {
    const auto [b, c] = allpass.section[static_cast<std::size_t>(i)];
    sections.push_back({b, c});
  }
  if (allpass.first_orders) out_[key]["first_order"] = allpass.a;
}

void JsonWriter::operator()(const char* key, const std::vector<float>& list, const Range& range) {
  Json& numbers = child(key, Kind::kList);
  for (const float x : list) numbers.push_back(rounded(static_cast<double>(x), range));
}

void JsonWriter::operator()(const char* key, const std::vector<float>& powers, const PowersInDb& kept) {
  Json& numbers = child(key, Kind::kList);
  for (const float x : powers) numbers.push_back(level(static_cast<double>(x), 10, kept.levels));
}

void JsonWriter::operator()(const char* level_key, const char* phase_key,
                            const std::vector<std::complex<float>>& orders, const Range& levels,
                            const Range& phases) {
  Json& level_list = child(level_key, Kind::kList);
  for (const std::complex<float> c : orders)
    level_list.push_back(level(static_cast<double>(std::abs(c)), 20, levels));
  Json& phase_list = child(phase_key, Kind::kList);
  for (const std::complex<float> c : orders)
    phase_list.push_back(rounded(static_cast<double>(std::arg(c)), phases));
}

std::string json_text(const Json& json) {
  std::string text;
  append(json, 0, text);
  return text + "\n";
}

}  // namespace rigsound::config
