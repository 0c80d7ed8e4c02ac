// The voice while it plays: resampler, speed tracker, cost.
#include <algorithm>
#include <chrono>
#include <vector>

#include "background/learning.hpp"
#include "background/table.hpp"
#include "diesel/diesel_layer.hpp"
#include "unit/engine/diesel/diesel_measures.hpp"

namespace rigsound::bench {
namespace {

using namespace rigsound::analysis;

constexpr int kBlock = 64, kBlocks = 2000, kRounds = 15;
constexpr double kRate = 48000;

/// Microseconds of every block, the least of kRounds runs of the same blocks.
std::vector<double> block_costs(const DieselModel& model, double rpm) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> least(kBlocks, 1e9);
  double sound[kBlock];
  for (int round = 0; round < kRounds; ++round) {
    rigsound::diesel::DieselLayer layer({model}, kRate, 1, 800);
    for (int n = 0; n < kRate; n += kChunk) layer.process({rpm, 0.5, 0.5}, sound);
    for (double& us : least) {
      const auto start = Clock::now();
      for (int n = 0; n < kBlock; n += kChunk) layer.process({rpm, 0.5, 0.5}, sound + n);
      us = std::min(us, std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    }
  }
  return least;
}

void cost_rows(Table& table) {
  DieselSettings settings;
  settings.name = "cost";
  std::vector<DieselTake> takes;
  for (const double rpm : {700.0, 1300.0, 2300.0}) takes.push_back(steady_take(rpm, 20, 1));
  const DieselModel model = learn_diesel(takes, settings).model;
  double mean = 0, worst = 0;
  for (const double rpm : {600.0, 1500.0, 2400.0}) {
    const std::vector<double> us = block_costs(model, rpm);
    double sum = 0;
    for (const double v : us) sum += v / kBlocks;
    mean = std::max(mean, sum), worst = std::max(worst, *std::max_element(us.begin(), us.end()));
  }
  table.at_most("cost of a block of 64, mean", 8, mean, "us");
  table.at_most("cost of a block of 64, worst", 12, worst, "us");
}

}  // namespace

void run_time_rows(Table& table) {
  const tests::ResamplingError resampling = tests::resampling_error();
  table.at_most("resampler, white", -85, resampling.white_db, "dB");
  table.at_most("resampler, engine-like", -105, resampling.engine_like_db, "dB");
  const tests::TrackerError tracker = tests::tracker_error();
  table.at_most("speed tracker, 20 ms messages, settled", 1, tracker.settled_cents, "cents");
  table.at_most("speed tracker, in the ramp", 8, tracker.ramp_cents, "cents");
  table.at_most("speed tracker, overshoot", 20, tracker.overshoot_cents, "cents");
  cost_rows(table);
}

}  // namespace rigsound::bench
