#include <cmath>

#include "field_check.hpp"
#include "rigsound/diesel_model.hpp"

namespace rigsound {
namespace {

constexpr std::size_t kMaxFilterOrder = 256;
constexpr Range kSlotSamples{16, 512, "samples a slot"};

bool power_of_two(int n) { return (n & (n - 1)) == 0; }

/// Poles inside the unit circle: every reflection coefficient of the step-down recursion is below 1.
bool stable(const std::vector<float>& A) {
  std::vector<double> a(A.begin(), A.end());
  for (std::size_t i = a.size() - 1; i >= 1; --i) {
    const double k = a[i];
    if (!(std::fabs(k) < 1)) return false;
    std::vector<double> lower(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(i));
    for (std::size_t j = 1; j < i; ++j) lower[j] = (a[j] - k * a[i - j]) / (1 - k * k);
    a.swap(lower);
  }
  return true;
}

void require_all_pole(const FieldCheck& check, const std::string& key, const std::vector<float>& A) {
  check.require(
      A.size() <= kMaxFilterOrder + 1, key,
      "has order " + std::to_string(A.size() - 1) + ", expected at most " + std::to_string(kMaxFilterOrder));
  check.require(A.empty() || (A[0] == 1.0F && stable(A)), key,
                "is no stable all-pole filter, expected 1, a[1], ... with its poles inside the unit circle");
}

void require_power(const FieldCheck& check, const std::string& key, int n) {
  check.require(power_of_two(n), key, "is " + std::to_string(n) + ", expected a power of two");
}

void require_size(const FieldCheck& check, const std::string& key, std::size_t size, std::size_t expected,
                  const std::string& shape) {
  check.require(
      size == expected, key,
      "has " + std::to_string(size) + " values, expected " + shape + " = " + std::to_string(expected));
}

void require_point(const FieldCheck& check, const DieselModel& model, const DieselPoint& p) {
  const auto L = static_cast<std::size_t>(model.slots);
  const std::size_t bands = slot_band_edges(model.slot_samples()).size() - 1;
  check.require(p.orders.size() < static_cast<std::size_t>(model.angle_samples / 2), "order_level_db",
                "has " + std::to_string(p.orders.size()) + " orders, expected fewer than N_theta / 2");
  require_size(check, "v_lo_db", p.low_variance.size(),
               static_cast<std::size_t>((model.low_scales + 1) * model.low_channels), "(N + 1) x P_lo");
  require_size(check, "v_hi_db", p.slot_variance.size(), L * bands, "L x bands");
  require_size(check, "s2", p.slot_log_variance.size(), L, "L");
  const auto grain = static_cast<std::size_t>(model.angle_samples * (1 + kGrainOverlap));
  for (const auto& g : p.grains) require_size(check, "grains", g.size(), grain, "1.25 N_theta samples");
}

}  // namespace

void require_valid(const DieselModel& model) {
  const FieldCheck check("background \"" + model.name + "\": ");
  check.ranges(model);
  require_power(check, "N_theta", model.angle_samples);
  require_power(check, "L", model.slots);
  require_power(check, "P_lo", model.low_channels);
  check.require(kSlotSamples.holds(model.slot_samples()), "L",
                "leaves " + std::to_string(model.slot_samples()) + ", expected " + kSlotSamples.text());
  require_all_pole(check, "A", model.body_filter);
  require_all_pole(check, "hydraulic.flow_A", model.hydraulic.flow_filter);
  check.require(model.body.db.size() != 1, "E.db", "has one value, expected none or at least two");
  check.require(!model.points.empty(), "points", "there is none, expected at least one point");
  for (std::size_t i = 0; i < model.points.size(); ++i)
    require_point(check.inside("points", i), model, model.points[i]);
}

}  // namespace rigsound
