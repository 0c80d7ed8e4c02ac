#include "clicks/rhythm.hpp"

#include <algorithm>
#include <cmath>

#include "clicks/gaps.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kShortestBar = 3, kLongestBar = 12;
constexpr int kRepeats = 3;  // of a bar, that it may count
constexpr int kRefinements = 5;
constexpr double kLeastStrength = 1e-9;
constexpr double kKnownTo = 0.05;  // nepers: how exactly a strength is fitted; equal clicks differ by less

/// The step of the best-fitting grid that each onset falls on.
std::vector<long> steps(const std::vector<long>& onset) {
  double T = median_gap(onset);
  std::vector<long> step(onset.size());
  for (int round = 0; round < kRefinements; ++round) {
    double products = 0, squares = 0;
    for (size_t i = 0; i < onset.size(); ++i) {
      const double time = static_cast<double>(onset[i] - onset.front());
      step[i] = std::lround(time / T);
      products += static_cast<double>(step[i]) * time;
      squares += static_cast<double>(step[i] * step[i]);
    }
    T = products / squares;
  }
  return step;
}

double squares_about_mean(const Eigen::ArrayXXd& level) {
  return (level.colwise() - level.rowwise().mean()).square().sum();
}

/// What the means of the places in a bar leave of the levels, a click a column.
struct BarRest {
  double squares = 0;
  int places = 0;  ///< that any click falls on
};

BarRest rest_of(int bar, const std::vector<long>& step, const Eigen::ArrayXXd& level) {
  BarRest rest;
  for (int place = 0; place < bar; ++place) {
    std::vector<long> here;
    for (size_t i = 0; i < step.size(); ++i)
      if (step[i] % bar == place) here.push_back(static_cast<long>(i));
    if (here.empty()) continue;
    ++rest.places;
    rest.squares += squares_about_mean(level(Eigen::all, here));
  }
  return rest;
}

double explained_by(int bar, const std::vector<long>& step, const Eigen::ArrayXXd& level) {
  const BarRest rest = rest_of(bar, step, level);
  const double n = static_cast<double>(level.cols());
  return 1 - (rest.squares / (n - rest.places)) / (squares_about_mean(level) / (n - 1));
}

/// -log10 of the probability that F with m and n degrees of freedom is larger (Paulson 1942).
double tail_decades(double F, double m, double n) {
  const double root = std::cbrt(F), a = 2 / (9 * m), b = 2 / (9 * n);
  const double z = ((1 - b) * root - (1 - a)) / std::sqrt(b * root * root + a);
  return -std::log10(std::max(0.5 * std::erfc(z / std::sqrt(2.0)), 1e-300));
}

}  // namespace

double strength_rhythm(const std::vector<double>& beta, const std::vector<long>& onset) {
  if (onset.size() < 3) return 0;
  const std::vector<long> step = steps(onset);
  const Eigen::ArrayXXd level =
      Eigen::Map<const Eigen::ArrayXXd>(beta.data(), 1, static_cast<long>(beta.size()))
          .max(kLeastStrength)
          .log();
  const double n = static_cast<double>(onset.size());
  double surest = 0;
  for (int bar = kShortestBar; bar <= kLongestBar && n >= kRepeats * bar; ++bar) {
    const BarRest before = rest_of(bar % 2 == 0 ? 2 : 1, step, level), after = rest_of(bar, step, level);
    const double m = after.places - before.places, free = n - after.places;
    if (m <= 0 || free <= 0) continue;
    const double scatter = std::max(after.squares / free, kKnownTo * kKnownTo);
    surest = std::max(surest, tail_decades((before.squares - after.squares) / m / scatter, m, free));
  }
  return surest;
}

double rhythm(const Eigen::ArrayXXd& level, const std::vector<long>& onset) {
  double best = 0;
  if (onset.size() < 3) return best;
  const std::vector<long> step = steps(onset);
  for (int bar = kShortestBar; bar <= kLongestBar && level.cols() >= kRepeats * bar; ++bar)
    best = std::max(best, explained_by(bar, step, level));
  return best;
}

}  // namespace rigsound::analysis
