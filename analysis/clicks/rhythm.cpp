#include "clicks/rhythm.hpp"

#include <algorithm>
#include <cmath>

#include "clicks/gaps.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kShortestBar = 3, kLongestBar = 12;
constexpr int kRepeats = 3;  // of a bar, that it may count
constexpr int kRefinements = 5;

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

double explained_by(int bar, const std::vector<long>& step, const Eigen::ArrayXXd& level) {
  double rest = 0;
  int places = 0;
  for (int place = 0; place < bar; ++place) {
    std::vector<long> here;
    for (size_t i = 0; i < step.size(); ++i)
      if (step[i] % bar == place) here.push_back(static_cast<long>(i));
    if (here.empty()) continue;
    ++places;
    rest += squares_about_mean(level(Eigen::all, here));
  }
  const double n = static_cast<double>(level.cols());
  return 1 - (rest / (n - places)) / (squares_about_mean(level) / (n - 1));
}

}  // namespace

double rhythm(const Eigen::ArrayXXd& level, const std::vector<long>& onset) {
  double best = 0;
  if (onset.size() < 3) return best;
  const std::vector<long> step = steps(onset);
  for (int bar = kShortestBar; bar <= kLongestBar && level.cols() >= kRepeats * bar; ++bar)
    best = std::max(best, explained_by(bar, step, level));
  return best;
}

}  // namespace rigsound::analysis
