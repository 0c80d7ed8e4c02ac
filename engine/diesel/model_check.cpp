#include <cmath>
#include <stdexcept>
#include <string>

#include "rigsound/diesel_model.hpp"

namespace rigsound {
namespace {

bool power_of_two(int n, int low, int high) { return n >= low && n <= high && (n & (n - 1)) == 0; }
bool within(double x, double low, double high) { return x >= low && x <= high; }

bool finite(const std::vector<float>& values, float low) {
  for (const float v : values)
    if (!std::isfinite(v) || v < low) return false;
  return true;
}

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

bool all_pole(const std::vector<float>& A) {
  return A.size() <= 257 && finite(A, -1e6F) && (A.empty() || (A[0] == 1.0F && stable(A)));
}

void require(const DieselModel& model, bool ok, const std::string& what) {
  if (!ok) throw std::invalid_argument("background '" + model.name + "': " + what);
}

void require_point(const DieselModel& model, const DieselPoint& p) {
  const auto L = static_cast<std::size_t>(model.slots);
  const std::size_t bands = slot_band_edges(model.slot_samples()).size() - 1;
  require(model, within(p.rpm, 300, 4000), "rpm of a point must lie in 300...4000");
  require(model, within(p.load, 0, 1), "load of a point must lie in 0...1");
  require(model, p.orders.size() < static_cast<std::size_t>(model.angle_samples / 2),
          "too many orders, must be below N_theta / 2");
  require(model,
          p.low_variance.size() == static_cast<std::size_t>((model.low_scales + 1) * model.low_channels) &&
              finite(p.low_variance, 0),
          "v_lo must hold (N + 1) x P_lo variances");
  require(model, p.slot_variance.size() == L * bands && finite(p.slot_variance, 0),
          "v_hi must hold L x bands variances");
  require(model, p.slot_log_variance.size() == L && finite(p.slot_log_variance, 0),
          "s2 must hold L variances");
  require(model, within(p.slot_correlation, 0, 0.95), "rho must lie in 0...0.95");
  const auto grain = static_cast<std::size_t>(model.angle_samples * (1 + kGrainOverlap));
  for (const auto& g : p.grains) require(model, g.size() == grain, "a grain must hold 1.25 N_theta samples");
}

}  // namespace

void require_valid(const DieselModel& model) {
  require(model, power_of_two(model.angle_samples, 1024, kMaxCrankAngle),
          "N_theta must be a power of two, 1024...8192");
  require(model,
          power_of_two(model.slots, 16, 256) && model.slot_samples() >= 16 && model.slot_samples() <= 512,
          "L must be a power of two, 16...256, with 16...512 samples a slot");
  require(model, power_of_two(model.low_channels, 64, 1024), "P_lo must be a power of two, 64...1024");
  require(model, model.low_scales >= 0 && model.low_scales <= 4, "N must lie in 0...4");
  require(model, within(model.crossover_hz, 200, 800), "f_x must lie in 200...800 Hz");
  require(model, within(model.sample_rate, 8000, 192000), "sample_rate must lie in 8000...192000 Hz");
  require(model, all_pole(model.body_filter), "A must begin with 1 and be stable, order at most 256");
  require(model, all_pole(model.hydraulic.flow_filter),
          "flow_A must begin with 1 and be stable, order at most 256");
  require(model, model.body.db.size() != 1 && finite(model.body.db, -200), "E needs at least two values");
  require(model, model.body.f_min > 0 && model.body.per_octave > 0, "E needs f_min > 0 and per_octave > 0");
  require(model, !model.points.empty(), "at least one point is needed");
  for (const DieselPoint& p : model.points) require_point(model, p);
}

}  // namespace rigsound
