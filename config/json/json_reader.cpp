#include "json/json_reader.hpp"

#include <cmath>

#include "rigsound/config/nearest_word.hpp"

namespace rigsound::config {
bool JsonReader::wanted(const char* key) {
  known_.emplace_back(key);
  return keys_ == JsonKeys::kAll || in_.has(key);
}

void JsonReader::refuse_unknown() const {
  if (keys_ == JsonKeys::kAll) return;
  for (const std::string& key : in_.keys()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string_view near = nearest_word(key, known_);
    in_.fail(key, near.empty() ? "is not known here, expected none of that name"
                               : "is not known here, did you mean '" + std::string(near) + "'?");
  }
}

void JsonReader::operator()(const char* key, double& x, const Range& range) {
  if (wanted(key)) x = in_.number(key, range);
}

void JsonReader::operator()(const char* key, int& x, const Range& range) {
  if (wanted(key)) x = static_cast<int>(in_.number(key, range.whole()));
}

void JsonReader::operator()(const char* key, bool& on) {
  if (wanted(key)) on = in_.flag(key);
}

void JsonReader::operator()(const char* key, std::string& text) {
  if (wanted(key)) text = in_.text(key);
}

void JsonReader::operator()(const char* key, Allpass& allpass, const Range& range) {
  if (!wanted(key)) return;
  const JsonFile in = in_.object(key);
  allpass = {};
  for (const auto& [b, c] : in.pairs("sections", range, kMaxSections))
    allpass.section[static_cast<std::size_t>(allpass.sections++)] = {b, c};
  if (!in.has("first_order")) return;
  allpass.first_orders = 1;
  allpass.a = in.number("first_order", range);
}

void JsonReader::operator()(const char* key, std::vector<float>& list, const Range& range) {
  if (wanted(key)) list = in_.floats(key, range);
}

void JsonReader::operator()(const char* key, std::vector<float>& powers, const PowersInDb& kept) {
  if (!wanted(key)) return;
  powers = in_.floats(key, kept.levels);
  for (float& x : powers)
    x = x <= static_cast<float>(kept.levels.min)
            ? 0.0F
            : static_cast<float>(std::pow(10.0, static_cast<double>(x) / 10));
}

void JsonReader::operator()(const char* level_key, const char* phase_key,
                            std::vector<std::complex<float>>& orders, const Range& levels,
                            const Range& phases) {
  if (!wanted(level_key) || !wanted(phase_key)) return;
  const std::vector<float> level = in_.floats(level_key, levels), phase = in_.floats(phase_key, phases);
  if (level.size() != phase.size())
    in_.fail(phase_key, "has another length than " + std::string(level_key) + ", expected " +
                            std::to_string(level.size()) + " numbers");
  orders.clear();
  for (std::size_t k = 0; k < level.size(); ++k)
    orders.push_back(std::polar(
        level[k] <= static_cast<float>(levels.min) ? 0.0F : std::pow(10.0F, level[k] / 20), phase[k]));
}

}  // namespace rigsound::config
