#include "field_check.hpp"

#include <cmath>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound {
namespace {

constexpr double kRounding = 1 + 1e-6;  // of a level that went through a file

}  // namespace

void FieldCheck::require(bool holds, std::string_view key, std::string_view problem) const {
  if (!holds) throw InvalidField(where_, path_ + std::string(key), std::string(problem));
}

void FieldCheck::hold(std::string_view key, double x, const Range& range) const {
  if (!range.holds(x)) throw InvalidField(where_, path_ + std::string(key), range.problem(x));
}

void FieldCheck::at_most(double limit, std::string_view name, double x, std::string_view key) const {
  require(x <= limit, key,
          "is " + number_text(x) + ", expected at most " + std::string(name) + ", " + number_text(limit));
}

FieldCheck FieldCheck::inside(const std::string& list, std::size_t index) const {
  return inside(list + "[" + std::to_string(index) + "]");
}

void FieldCheck::operator()(const char* key, const Allpass& allpass, const Range& range) const {
  const FieldCheck check = inside(key);
  check.hold("sections", allpass.sections, {0, kMaxSections});
  for (int i = 0; i < allpass.sections; ++i) {
    const auto [b, c] = allpass.section[i];
    check.hold("sections", b, range);
    check.hold("sections", c, range);
  }
  check.hold("first_order", allpass.a, range);
}

void FieldCheck::operator()(const char* key, const std::vector<float>& list, const Range& range) const {
  for (const float x : list) hold(key, static_cast<double>(x), range);
}

void FieldCheck::operator()(const char* key, const std::vector<float>& powers, const PowersInDb& kept) const {
  const double highest = dsp::exp(kept.levels.max * (dsp::kLn10 / 10)) * kRounding;
  for (const float x : powers) hold(key, static_cast<double>(x), {0, highest});
}

void FieldCheck::operator()(const char* level_key, const char*,
                            const std::vector<std::complex<float>>& orders, const Range& levels,
                            const Range&) const {
  const double highest = dsp::gain_of_db(levels.max) * kRounding;
  for (const std::complex<float> c : orders)
    hold(level_key, std::sqrt(static_cast<double>(std::norm(c))), {0, highest});
}

}  // namespace rigsound
