#include "diesel/source_point.hpp"

#include <algorithm>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::diesel {
namespace {

constexpr double kTaper_hz = 1600;
constexpr double kSmallest = 1e-10;  // -200 dB stands for nothing: its logarithm is finite

double ln(double x) { return dsp::log(std::max(x, kSmallest)); }

/// Body on the channels of the low layer; channel q lies at order (q + 1/2) / 2.
void add_body_lo(const DieselModel& model, double rpm, double sign, std::vector<double>& lo) {
  const std::size_t P = static_cast<std::size_t>(model.low_channels);
  for (std::size_t i = 0; i < lo.size(); ++i) {
    const double order = (static_cast<double>(i % P) + 0.5) / 2;
    lo[i] += sign * body_db(model.body, order * cycles_per_second(rpm)) * (dsp::kLn10 / 20);
  }
}

double mixed(double a, double b, double way) { return a + (b - a) * way; }

std::vector<double> mixed(const std::vector<double>& a, const std::vector<double>& b, double way) {
  std::vector<double> y = a.size() >= b.size() ? a : b;  // what only one has stays as it is
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) y[i] = mixed(a[i], b[i], way);
  return y;
}

double wrapped(double phase) { return phase - dsp::kTwoPi * std::floor(phase / dsp::kTwoPi + 0.5); }

}  // namespace

double body_db(const BodyResponse& E, double f_hz) {
  if (E.db.empty()) return 0;
  const double last = static_cast<double>(E.db.size() - 1);
  const double place =
      std::clamp(dsp::log(std::max(f_hz, 1e-3) / E.f_min) / dsp::kLn2 * E.per_octave, 0.0, last);
  const auto i = std::min(static_cast<std::size_t>(place), E.db.size() - 2);
  const double value =
      mixed(static_cast<double>(E.db[i]), static_cast<double>(E.db[i + 1]), place - static_cast<double>(i));
  const double r2 = (f_hz / kTaper_hz) * (f_hz / kTaper_hz);
  return value / (1 + r2 * r2 * r2 * r2);
}

SourcePoint source_of(const DieselModel& model, const DieselPoint& point) {
  SourcePoint s;
  const double f = cycles_per_second(point.rpm);
  for (std::size_t k = 1; k <= point.orders.size(); ++k) {
    const auto re = static_cast<double>(point.orders[k - 1].real()),
               im = static_cast<double>(point.orders[k - 1].imag());
    const double body = body_db(model.body, static_cast<double>(k) * f) * (dsp::kLn10 / 20);
    s.level.push_back(ln(std::sqrt(re * re + im * im)) - body);
    s.phase.push_back(dsp::atan2(im, re));
  }
  for (const float v : point.low_variance) s.lo.push_back(ln(std::sqrt(static_cast<double>(v))));
  for (const float v : point.slot_variance) s.hi.push_back(ln(std::sqrt(static_cast<double>(v))));
  for (const float v : point.slot_log_variance) s.s.push_back(std::sqrt(static_cast<double>(v)));
  s.rho = point.slot_correlation;
  add_body_lo(model, point.rpm, -1, s.lo);
  return s;
}

SourcePoint between(const SourcePoint& a, const SourcePoint& b, double way) {
  SourcePoint y;
  y.level = mixed(a.level, b.level, way);
  y.phase = a.phase.size() >= b.phase.size() ? a.phase : b.phase;
  for (std::size_t i = 0; i < std::min(a.phase.size(), b.phase.size()); ++i)
    y.phase[i] = a.phase[i] + way * wrapped(b.phase[i] - a.phase[i]);
  y.lo = mixed(a.lo, b.lo, way);
  y.hi = mixed(a.hi, b.hi, way);
  y.s = mixed(a.s, b.s, way);
  y.rho = mixed(a.rho, b.rho, way);
  return y;
}

SourceMap::SourceMap(const DieselModel& model) {
  std::vector<const DieselPoint*> points;
  for (const DieselPoint& p : model.points) points.push_back(&p);
  std::sort(points.begin(), points.end(), [](const DieselPoint* a, const DieselPoint* b) {
    return a->load != b->load ? a->load < b->load : a->rpm < b->rpm;
  });
  for (const DieselPoint* point : points) {
    if (rows_.empty() || rows_.back().load != point->load) rows_.push_back({point->load, {}});
    rows_.back().points.push_back({point->rpm, source_of(model, *point)});
  }
  const auto by_rpm = [](const DieselPoint& a, const DieselPoint& b) { return a.rpm < b.rpm; };
  const auto ends = std::minmax_element(model.points.begin(), model.points.end(), by_rpm);
  slowest_rpm_ = ends.first->rpm, fastest_rpm_ = ends.second->rpm;
}

SourcePoint SourceMap::along(const Row& row, double rpm) {
  const std::vector<Known>& points = row.points;
  std::size_t upper = 0;
  while (upper < points.size() && points[upper].rpm < rpm) ++upper;
  if (upper == 0) return points.front().source;
  if (upper == points.size()) return points.back().source;
  const Known &a = points[upper - 1], &b = points[upper];
  const double way = dsp::log(rpm / a.rpm) / dsp::log(b.rpm / a.rpm);
  return between(a.source, b.source, way);
}

SourcePoint SourceMap::at(double rpm, double load) const {
  std::size_t upper = 0;
  while (upper + 1 < rows_.size() && rows_[upper].load < load) ++upper;
  const std::size_t lower = upper > 0 && rows_[upper].load > load ? upper - 1 : upper;
  if (lower == upper) return along(rows_[upper], rpm);
  return between(along(rows_[lower], rpm), along(rows_[upper], rpm),
                 (load - rows_[lower].load) / (rows_[upper].load - rows_[lower].load));
}

}  // namespace rigsound::diesel
