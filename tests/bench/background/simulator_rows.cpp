// The simulated diesel, whose truth is known at every speed: what happens between and beyond the banks.
#include <algorithm>
#include <cmath>
#include <vector>

#include "background/learning.hpp"
#include "background/table.hpp"
#include "diesel/angle_domain.hpp"
#include "diesel/compared_cycles.hpp"
#include "diesel/order_analysis.hpp"
#include "diesel/source_point.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::bench {
namespace {

using namespace rigsound::analysis;

constexpr double kBank_s = 30;
constexpr double kHighest_hz = 9000;
constexpr int kTruthSeed = 100;

std::vector<DieselTake> banks(const std::vector<double>& speeds) {
  std::vector<DieselTake> takes;
  for (std::size_t i = 0; i < speeds.size(); ++i)
    takes.push_back(steady_take(speeds[i], kBank_s, static_cast<unsigned>(i + 1)));
  return takes;
}

DieselModel learned(const std::vector<DieselTake>& takes) {
  DieselSettings settings;
  settings.name = "simulated";
  return learn_diesel(takes, settings).model;
}

/// Mean power of every 100 ms in third-octave bands: bands x frames.
std::vector<double> third_octave_frames(const std::vector<double>& x) {
  constexpr std::size_t kFrame = 4800;
  std::vector<double> powers;
  for (double centre = 50; centre < kHighest_hz; centre *= std::cbrt(2.0)) {
    const double edge = std::pow(2, 1.0 / 6);
    const std::vector<double> band = zero_phase_low_pass(
        zero_phase_high_pass(x, centre / edge, kAnalysisRate), centre * edge, kAnalysisRate);
    for (std::size_t at = 0; at + kFrame <= band.size(); at += kFrame) {
      double power = 1e-12;
      for (std::size_t n = at; n < at + kFrame; ++n) power += band[n] * band[n] / kFrame;
      powers.push_back(power);
    }
  }
  return powers;
}

double distance_db(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  const std::size_t count = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < count; ++i) sum += std::pow(10 * std::log10(a[i] / b[i]), 2);
  return std::sqrt(sum / static_cast<double>(count));
}

std::vector<double> run_up() {
  std::vector<double> rpm = steady_rpm(600, 1);
  for (const double v : ramp_rpm(600, 2400, 2)) rpm.push_back(v);
  for (const double v : steady_rpm(2400, 1)) rpm.push_back(v);
  return rpm;
}

std::vector<double> true_run_up(int seed) {
  DieselRun run;
  run.rpm = run_up(), run.seed = static_cast<std::uint64_t>(seed);
  return third_octave_frames(simulate_diesel(run).sound);
}

void ramp_rows(Table& table) {
  std::vector<double> truth;
  for (int seed = kTruthSeed; seed < kTruthSeed + 3; ++seed) {
    const std::vector<double> one = true_run_up(seed);
    truth.resize(one.size());
    for (std::size_t i = 0; i < one.size(); ++i) truth[i] += one[i] / 3;
  }
  const std::vector<float> y = play_diesel(learned(banks({600, 1200, 2400})), run_up(), 0, 0, 1);
  table.at_most("600 -> 2400 r/min in 2 s, banks at 600, 1200, 2400", 2.0,
                distance_db(third_octave_frames({y.begin(), y.end()}), truth), "dB");
  table.note("  the same machine once more (floor)", distance_db(true_run_up(kTruthSeed + 3), truth), "dB");
}

/// Third-octave error of `model` at a speed no bank has.
double error_at(const DieselModel& model, double rpm) {
  DieselPoint here = model.points.front();
  here.rpm = rpm;
  const CyclicSound played = played_cycles(model, here, 100, 1);
  const CyclicSound truth =
      recorded_cycles(section_of(steady_take(rpm, kBank_s, kTruthSeed)), here, model.angle_samples);
  return likeness(played, truth, kHighest_hz).third_octave_db;
}

/// Banks at `speeds`, and a run-up that only tells what the body is like.
DieselModel learned_with_run_up(const std::vector<double>& speeds) {
  std::vector<DieselTake> takes = banks(speeds);
  takes.push_back(simulated_take(ramp_rpm(700, 2200, kBank_s), 20));
  DieselModel model = learned(takes);
  model.points.resize(speeds.size());
  return model;
}

void one_bank_rows(Table& table) {
  const DieselModel model = learned_with_run_up({1200});
  table.at_most("one bank at 1200 r/min and a run-up, played at 960", 2.0, error_at(model, 960), "dB");
  table.at_most("one bank at 1200 r/min and a run-up, played at 1440", 2.0, error_at(model, 1440), "dB");
}

/// rms error of the orders that rise 20 dB over chance, 30 ... 2400 Hz.
double order_error(const DieselModel& model, double rpm) {
  const Section s = section_of(steady_take(rpm, kBank_s, kTruthSeed + 5));
  const CycleBlock block = cycles_of(s, s.x, 0, model.angle_samples);
  const int last = static_cast<int>(2400 / s.f0());
  const Orders truth = orders_of(block, 0, block.cycles, last);
  const diesel::SourcePoint source = diesel::SourceMap(model).at(rpm, 0);
  double sum = 0;
  int count = 0;
  for (int k = 1; k <= last; ++k) {
    const auto i = static_cast<std::size_t>(k - 1);
    const double power = std::norm(truth.C[i]), f = k * s.f0();
    if (f < 30 || power < 100 * truth.noise[i] || i >= source.level.size()) continue;
    const double db = source.level[i] * 20 / std::log(10) + diesel::body_db(model.body, f);
    sum += std::pow(db - 10 * std::log10(power - truth.noise[i]), 2), ++count;
  }
  return std::sqrt(sum / count);
}

void order_rows(Table& table) {
  const DieselModel model = learned_with_run_up({800, 1200, 1800});
  table.at_most("orders midway between banks at 800 and 1200 r/min", 3.0, order_error(model, 1000), "dB");
  table.at_most("orders midway between banks at 1200 and 1800 r/min", 3.0, order_error(model, 1500), "dB");
  // A body that repeats every 1.5 in frequency looks the same from all three of these banks.
  const DieselModel banks_alone = learned(banks({800, 1200, 1800}));
  table.note("  without the run-up, at 1000 r/min", order_error(banks_alone, 1000), "dB");
  table.note("  without the run-up, at 1500 r/min", order_error(banks_alone, 1500), "dB");
}

}  // namespace

void simulator_rows(Table& table) {
  ramp_rows(table);
  one_bank_rows(table);
  order_rows(table);
}

}  // namespace rigsound::bench
