#include "tool/design/loop_designer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tool/design/allpass_fit.hpp"
#include "tool/design/loop_response.hpp"

namespace rigsound::tool {
namespace {

using dsp::kTwoPi;

constexpr double kCentsPerNeper = 1200 / dsp::kLn2;
constexpr double kHopelessCents = 8;
constexpr double kWorstDecayShare = 0.5;  // rather than no tool at all
constexpr double kBeside = 0.25;  // mode numbers between a mode and the points that hold its round trip
constexpr int kFirstSteps = 60, kRefineSteps = 30, kRefinements = 4;

bool reached(const LoopTask& task, const LoopError& error, double cents) {
  return error.cents <= cents && error.decay_share <= task.decay_share;
}

/// Prefers what is accepted over what is not, then the better tuned.
double badness(const LoopTask& task, const LoopError& error) {
  constexpr double kRefused = 1e3;
  return (reached(task, error, task.cents_limit) ? 0 : kRefused) + error.cents / task.cents_limit +
         10 * std::max(0.0, error.decay_share / task.decay_share - 1) +
         10 * std::max(0.0, error.cents / task.cents_limit - 1);
}

/// Coefficients of 24 bits: a file can hold them exactly, and it costs less than 1e-4 cent.
double rounded(double x) { return static_cast<float>(x); }

void round_coefficients(Allpass& allpass) {
  for (AllpassSection& s : allpass.section) s = {rounded(s.b), rounded(s.c)};
  allpass.a = rounded(allpass.a);
}

double k_ref(const LoopDesign& loop) { return 0.5 * (loop.reflection_min + loop.reflection_max); }

/// Wanted lags of one (order, N), and the poles an allpass fitted to them gives.
class Attempt {
 public:
  Attempt(const ModeLaw& law, const LoopTask& task, int N) : task_(task) {
    loop_.delay_samples = N;
    loop_.filters = task.filters;
    loop_.reflection_min = task.k_min, loop_.reflection_max = task.k_max;
    const int modes = law.count_below(mode_limit(task.sample_rate));
    shift_.resize(static_cast<std::size_t>(modes), 0.0);
    for (int k = 1; k <= modes; ++k) {
      add_point(law, k - kBeside, task.beside_weight);
      add_point(law, k, 1);
      add_point(law, k + kBeside, task.beside_weight);
      ideal_.push_back(ideal_t60_samples(law, task.filters, k_ref(loop_), k, task.sample_rate));
    }
  }

  Allpass first_guess(int order, double width) const { return sliced_allpass(points_, order, width); }

  /// Fits the lag, then moves the targets by what the closed-loop poles are off, and fits again.
  DesignedLoop run(Allpass allpass, int first_steps) {
    DesignedLoop best{loop_, {1e9, 1e9}};
    std::fill(shift_.begin(), shift_.end(), 0.0);
    for (int i = 0, steps = first_steps; i <= kRefinements; ++i, steps = kRefineSteps) {
      allpass = fit_lag(allpass, shifted_points(), steps, 0.05 * task_.cents);
      loop_.allpass = allpass;
      round_coefficients(loop_.allpass);
      const LoopError error = judge();
      if (badness(task_, error) < badness(task_, best.error)) best = {loop_, error};
      if (reached(task_, best.error, task_.cents) || error.cents > kHopelessCents) break;
    }
    return best;
  }

 private:
  void add_point(const ModeLaw& law, double kappa, double weight) {
    const double omega = kTwoPi * law.at(kappa) / task_.sample_rate;
    const double round_trip = law.density(kappa) * task_.sample_rate;
    points_.push_back({omega, kTwoPi * kappa - loop_.delay_samples * omega - lag(task_.filters, omega),
                       weight * kCentsPerNeper / (round_trip * omega)});
  }

  /// The wanted lags with every mode moved by its shift, and what lies beside it as well.
  std::vector<LagPoint> shifted_points() const {
    std::vector<LagPoint> points = points_;
    // A mode that shall lie higher has not yet turned as far at the old frequency.
    for (std::size_t i = 0; i < points.size(); ++i) points[i].lag -= shift_[i / 3] / mode_point(i / 3).weight;
    return points;
  }

  const LagPoint& mode_point(std::size_t k) const { return points_[3 * k + 1]; }

  /// Measures the loop and lets the shifts make up for what is found.
  LoopError judge() {
    LoopError error;
    for (std::size_t k = 0; k < shift_.size(); ++k) {
      const double omega = mode_point(k).omega;
      const Pole pole = closed_loop_pole(loop_, k_ref(loop_), omega);
      const double cents = kCentsPerNeper * dsp::log(pole.omega / omega);
      error.cents = std::max(error.cents, std::fabs(cents));
      error.decay_share = std::max(error.decay_share, std::fabs(t60_samples(pole.sigma) / ideal_[k] - 1));
      shift_[k] -= cents;
    }
    return error;
  }

  const LoopTask& task_;
  LoopDesign loop_;
  std::vector<double> shift_, ideal_;  ///< per mode: cents its target is moved; T60 it should have, samples
  std::vector<LagPoint> points_;       ///< three a mode: below it, at it, above it
};

/// Mode number at half the sample rate. Above the modes that are tuned the loop may do as it likes, so there
/// it follows the law or goes on in a straight line, whichever takes it fewer turns: Rayleigh-Love's own
/// would never reach the half of a high rate.
double top_mode(const ModeLaw& law, double sample_rate) {
  const int modes = law.count_below(mode_limit(sample_rate));
  double low = modes, high = modes + (sample_rate / 2 - law.at(modes)) * law.density(modes);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (law.at(middle) < sample_rate / 2 ? low : high) = middle;
  }
  return high;
}

class Search {
 public:
  Search(const ModeLaw& law, const LoopTask& task)
      : law_(law),
        task_(task),
        half_turns_(static_cast<int>(std::ceil(2 * top_mode(law, task.sample_rate)))) {
    const int modes = law.count_below(mode_limit(task.sample_rate));
    if (modes < 1)
      throw std::invalid_argument("length_m: the bar has no mode below 18 kHz, expected a longer bar");
    round_trip_ = task.sample_rate / (law.at(modes + 0.5) - law.at(modes - 0.5));
    highest_order_ = std::min(task.max_order, 2 * modes + 8);
  }

  DesignedLoop run() {
    const int spare = static_cast<int>(std::floor(task_.spare_delay * round_trip_));
    const int lowest = std::clamp(half_turns_ - spare, task_.lowest_order, task_.preferred_order - 2);
    for (int order = lowest; order <= highest_order_; ++order) {
      if (order > task_.preferred_order && reached(task_, best_.error, task_.cents_limit)) break;
      for (const int more : {0, 1, -1, -2})
        if (attempt(order, half_turns_ + more - order)) return best_;
    }
    if (best_.error.cents > task_.cents_limit || best_.error.decay_share > kWorstDecayShare)
      throw std::invalid_argument("length_m: no loop of order " + std::to_string(highest_order_) +
                                  " tunes this bar, expected 0.3...1 m and 15...50 mm");
    return best_;
  }

 private:
  /// True when the aim is reached.
  bool attempt(int order, int N) {
    if (N < (order + 1) / 2 || N < 1 || N > round_trip_) return false;
    Attempt trial(law_, task_, N);
    for (const double width : {1.2, 0.7}) {
      const DesignedLoop found = trial.run(trial.first_guess(order, width), kFirstSteps);
      if (badness(task_, found.error) < badness(task_, best_.error)) best_ = found;
      if (reached(task_, best_.error, task_.cents)) return true;
    }
    return false;
  }

  const ModeLaw& law_;
  const LoopTask& task_;
  int half_turns_, highest_order_ = 0;
  double round_trip_ = 0;  ///< samples, of the highest mode tuned
  DesignedLoop best_{{}, {1e9, 1e9}};
};

}  // namespace

double mode_limit(double sample_rate) { return std::min(18000.0, kHighestMode * sample_rate); }

double ideal_t60_samples(const ModeLaw& law, const LoopFilters& filters, double k, int mode,
                         double sample_rate) {
  const double omega = kTwoPi * law.at(mode) / sample_rate;
  const double gain = k * dsp::magnitude(response(filters, {0, dsp::tan(omega / 2)}));
  return 3 * dsp::kLn10 * law.density(mode) * sample_rate / -dsp::log(gain);
}

DesignedLoop design_loop(const ModeLaw& law, const LoopTask& task) { return Search(law, task).run(); }

DesignedLoop retune_loop(const ModeLaw& law, const LoopTask& task, const LoopDesign& loop) {
  return Attempt(law, task, loop.delay_samples).run(loop.allpass, kRefineSteps);
}

}  // namespace rigsound::tool
