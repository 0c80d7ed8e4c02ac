#include "tool/design/allpass_fit.hpp"

#include <algorithm>
#include <cmath>

#include "tool/design/loop_response.hpp"

namespace rigsound::tool {
namespace {

using dsp::kPi;
using Vector = std::vector<double>;

/// Omega at which the piecewise linear curve through `points` (and the origin, and order * pi at pi) has
/// reached `lag`. Made monotone and squeezed below the allpass's total first.
class LagCurve {
 public:
  LagCurve(const std::vector<LagPoint>& points, int order) {
    omega_.push_back(0), lag_.push_back(0);
    for (const LagPoint& p : points) {
      omega_.push_back(p.omega);
      lag_.push_back(std::max(p.lag, lag_.back() + 1e-9));
    }
    const double total = order * kPi, squeeze = std::min(1.0, 0.98 * total / lag_.back());
    for (double& l : lag_) l *= squeeze;
    omega_.push_back(kPi), lag_.push_back(total);
  }

  double omega_at(double lag) const {
    for (std::size_t i = 1; i < lag_.size(); ++i)
      if (lag <= lag_[i])
        return omega_[i - 1] + (omega_[i] - omega_[i - 1]) * (lag - lag_[i - 1]) / (lag_[i] - lag_[i - 1]);
    return kPi;
  }

 private:
  Vector omega_, lag_;
};

int parameters(const Allpass& a) { return 2 * a.sections + a.first_orders; }

Vector to_logs(const Allpass& a) {
  Vector u;
  for (int i = 0; i < a.sections; ++i) {
    u.push_back(dsp::log(a.section[static_cast<std::size_t>(i)].b));
    u.push_back(dsp::log(a.section[static_cast<std::size_t>(i)].c));
  }
  if (a.first_orders) u.push_back(dsp::log(a.a));
  return u;
}

void from_logs(const Vector& u, Allpass& a) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.sections); ++i)
    a.section[i] = {dsp::exp(u[2 * i]), dsp::exp(u[2 * i + 1])};
  if (a.first_orders) a.a = dsp::exp(u.back());
}

/// Solves H x = g for symmetric positive H (lower triangle, row major, overwritten); x replaces g.
bool solve_cholesky(Vector& H, Vector& g) {
  const std::size_t n = g.size();
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      double s = H[i * n + j];
      for (std::size_t k = 0; k < j; ++k) s -= H[i * n + k] * H[j * n + k];
      if (i == j && !(s > 0)) return false;
      H[i * n + j] = i == j ? std::sqrt(s) : s / H[j * n + j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) g[i] -= H[i * n + k] * g[k];
    g[i] /= H[i * n + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) g[i] -= H[k * n + i] * g[k];
    g[i] /= H[i * n + i];
  }
  return true;
}

class LagFit {
 public:
  LagFit(const Allpass& start, const std::vector<LagPoint>& points)
      : points_(points),
        current_(start),
        u_(to_logs(start)),
        residual_(points.size()),
        n_(static_cast<std::size_t>(parameters(start))),
        H_(n_ * n_),
        g_(n_),
        row_(n_) {
    cost_ = cost_of(current_, residual_);
  }

  Allpass run(int steps, double good_enough) {
    for (int i = 0; i < steps; ++i) {
      const double before = cost_;
      build_normal_equations();
      if (!step_downhill() || worst() < good_enough || before - cost_ < 1e-10 * before) break;
    }
    return current_;
  }

 private:
  double cost_of(const Allpass& allpass, Vector& residual) const {
    double sum = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      residual[i] = points_[i].weight * (lag(allpass, points_[i].omega) - points_[i].lag);
      sum += residual[i] * residual[i];
    }
    return sum;
  }

  double worst() const {
    double most = 0;
    for (const double r : residual_) most = std::max(most, std::fabs(r));
    return most;
  }

  /// Derivatives of residual i by every logarithm.
  void fill_row(std::size_t i) {
    const double O = dsp::tan(points_[i].omega / 2), weight = 2 * points_[i].weight;
    for (std::size_t s = 0; s < static_cast<std::size_t>(current_.sections); ++s) {
      const auto [b, c] = current_.section[s];
      const double x = c - O * O, y = b * O, scale = weight * y / (x * x + y * y);
      row_[2 * s] = scale * x;
      row_[2 * s + 1] = -scale * c;
    }
    if (current_.first_orders) row_.back() = -weight * current_.a * O / (current_.a * current_.a + O * O);
  }

  void build_normal_equations() {
    std::fill(H_.begin(), H_.end(), 0.0);
    std::fill(g_.begin(), g_.end(), 0.0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      fill_row(i);
      for (std::size_t a = 0; a < n_; ++a) {
        g_[a] -= row_[a] * residual_[i];
        for (std::size_t b = 0; b <= a; ++b) H_[a * n_ + b] += row_[a] * row_[b];
      }
    }
  }

  /// Raises the damping until a step lowers the cost.
  bool step_downhill() {
    double trace = 0;
    for (std::size_t a = 0; a < n_; ++a) trace += H_[a * n_ + a];
    for (int attempt = 0; attempt < 12; ++attempt) {
      Vector H = H_, g = g_;
      for (std::size_t a = 0; a < n_; ++a)
        H[a * n_ + a] += damping_ * (H_[a * n_ + a] + 1e-9 * trace / static_cast<double>(n_) + 1e-300);
      if (solve_cholesky(H, g) && accept(g)) {
        damping_ = std::max(damping_ / 6, 1e-13);
        return true;
      }
      damping_ *= 4;
    }
    return false;
  }

  bool accept(const Vector& step) {
    Vector u = u_, residual(points_.size());
    for (std::size_t a = 0; a < n_; ++a) u[a] = std::clamp(u[a] + std::clamp(step[a], -1.0, 1.0), -25.0, 8.0);
    Allpass next = current_;
    from_logs(u, next);
    const double cost = cost_of(next, residual);
    if (!(cost < cost_)) return false;
    current_ = next, cost_ = cost;
    u_.swap(u), residual_.swap(residual);
    return true;
  }

  const std::vector<LagPoint>& points_;
  Allpass current_;
  Vector u_, residual_;
  std::size_t n_;
  Vector H_, g_, row_;
  double cost_ = 0, damping_ = 1e-2;
};

}  // namespace

Allpass sliced_allpass(const std::vector<LagPoint>& points, int order, double width) {
  const LagCurve curve(points, order);
  Allpass allpass;
  allpass.sections = order / 2;
  allpass.first_orders = order % 2;
  double done = 0;
  if (order % 2) {
    allpass.a = dsp::tan(std::clamp(curve.omega_at(kPi / 2), 1e-4, kPi - 1e-3) / 2);
    done = kPi;
  }
  for (int m = 0; m < allpass.sections; ++m, done += dsp::kTwoPi) {
    const double middle = std::clamp(curve.omega_at(done + kPi), 1e-4, kPi - 0.06);
    const double low = std::min(curve.omega_at(done), 0.999 * middle);
    const double high = std::max(std::min(curve.omega_at(done + dsp::kTwoPi), kPi - 0.05), 1.001 * middle);
    const double t = dsp::tan(middle / 2);
    allpass.section[static_cast<std::size_t>(m)] = {width * (dsp::tan(high / 2) - dsp::tan(low / 2)), t * t};
  }
  return allpass;
}

Allpass fit_lag(const Allpass& start, const std::vector<LagPoint>& points, int steps, double good_enough) {
  return LagFit(start, points).run(steps, good_enough);
}

}  // namespace rigsound::tool
