// offline_soak HOURS [SEED]: random shifts for so many hours of sound, as fast as the engine renders them.
// Watches for what an ear or a cabin PC would mind; ends with 1 when it finds any.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "rigsound/dsp/random.hpp"
#include "rigsound/engine.hpp"
#include "rigsound/machine/signal.hpp"

using namespace rigsound;

namespace {

constexpr int kBlock = 512;
constexpr double kRate = 48000, kBlocksASecond = kRate / kBlock;
constexpr double kSteadyEvery_s = 300, kSteady_s = 15;  // drilling without a change: would a loop be heard?
constexpr double kReloadEvery_s = 600;

constexpr double kMostDc = 0.02, kMostAlike = 0.9, kMostGrowth_mb = 32;

EngineOptions soak_options(std::uint64_t seed) {
  EngineOptions options = tools::full_options(kBlock);
  options.booms.resize(1);
  options.seed = seed;
  return options;
}

/// What a machine is told in a phase of 1...20 s: any situation, any value within its range.
class RandomShift {
 public:
  explicit RandomShift(std::uint64_t seed) : random_(seed, 77) {}

  const MachineState& at(double second) {
    const bool steady = std::fmod(second, kSteadyEvery_s) < kSteady_s;
    if (steady != steady_) next_s_ = second;
    steady_ = steady;
    if (second < next_s_) return state_;
    ++phase_;
    next_s_ = second + (steady ? kSteady_s : 1 + 19 * random_.uniform(phase_, 0));
    state_ = {};
    if (steady)
      drill_steadily();
    else
      draw();
    return state_;
  }
  bool steady() const { return steady_; }

 private:
  void drill_steadily() {
    state_.engine_rpm = 1800;
    state_.boom[0].feed_pressure_bar = 90;
  }
  void draw() {
    state_.engine_rpm = static_cast<float>(2200 * random_.uniform(phase_, 1));
    if (random_.uniform(phase_, 2) < 0.2) return;  // a pause
    state_.boom[0].feed_pressure_bar = static_cast<float>(200 * random_.uniform(phase_, 3));
    std::uint64_t field = 4;
    for_each_signal(1, [&](SignalId id) {
      const SignalInfo& signal = info(id.signal);
      const bool wanted = id.signal != Signal::kEngineRpm && id.signal != Signal::kFeedPressureBar &&
                          id.signal != Signal::kMasterGainDb && id.signal != Signal::kSimulation;
      if (!wanted || random_.uniform(phase_, field++) < 0.7) return;
      const double value = signal.min + (signal.max - signal.min) * random_.uniform(phase_, field++);
      signal.set(state_, 0, signal.stepped() ? std::round(value) : value);
    });
  }

  dsp::RandomField random_;
  std::uint64_t phase_ = 0;
  double next_s_ = 0;
  bool steady_ = false;
  MachineState state_;
};

/// Of a steady stretch the waveform at a sixteenth of the rate, differences only: how alike a second of it is
/// to any other, half a second to ten later. Hammering is regular, so levels alone would tell nothing.
class LoopWatch {
 public:
  void add(const float* block, int channels) {
    constexpr int kFrames = 16;
    for (int first = 0; first < kBlock; first += kFrames) {
      double sum = 0;
      for (int i = first; i < first + kFrames; ++i) sum += static_cast<double>(block[i * channels]);
      wave_.push_back(static_cast<float>(sum - last_));
      last_ = sum;
    }
  }
  /// The highest correlation, 1: a loop; then begins anew.
  double finish() {
    constexpr std::size_t kLength = 3000, kFirst = 12000;  // one second, after four on the way there
    float highest = 0;
    for (std::size_t at = kFirst + kLength / 2; at + kLength <= wave_.size(); ++at)
      highest = std::max(highest, correlation(kFirst, at, kLength));
    wave_.clear();
    return static_cast<double>(highest);
  }
  bool any() const { return !wave_.empty(); }

 private:
  float correlation(std::size_t first, std::size_t second, std::size_t length) const {
    float ab = 0, aa = 1e-30F, bb = 1e-30F;
    for (std::size_t i = 0; i < length; ++i) {
      const float a = wave_[first + i], b = wave_[second + i];
      ab += a * b;
      aa += a * a;
      bb += b * b;
    }
    return ab / std::sqrt(aa * bb);
  }
  std::vector<float> wave_;
  double last_ = 0;
};

std::uint64_t hash_of(const std::vector<float>& block) {
  std::uint64_t hash = 1;
  for (const float sample : block) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &sample, sizeof bits);
    hash = dsp::mix64(hash + bits);
  }
  return hash;
}

double memory_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmRSS:", 0) == 0) return std::atof(line.c_str() + 6) / 1024;
  return 0;
}

struct Found {
  std::uint64_t blocks = 0, not_finite = 0, over_ceiling = 0, repeated = 0;
  double peak = 0, most_dc = 0, most_alike = 0;
};

/// Sum, energy and samples of a stretch.
struct Stretch {
  double sum = 0, energy = 0, samples = 0;
};

/// Tells `figures` eight times how it goes; null: nobody.
Found soak(double hours, std::uint64_t seed, std::FILE* figures) {
  Found found;
  std::uint64_t reloads = 0;
  auto engine = std::make_unique<Engine>(soak_options(seed), tools::formula_sounds());
  const EngineOptions options = engine->options();
  const double ceiling = std::pow(10, options.mix.ceiling_dbfs / 20) * (1 + 1e-6);
  RandomShift shift(seed);
  LoopWatch loops;
  Stretch eighth;
  std::vector<float> block(static_cast<std::size_t>(kBlock * options.channels));
  std::unordered_set<std::uint64_t> seen;
  const auto blocks = static_cast<std::uint64_t>(hours * 3600 * kBlocksASecond);
  seen.reserve(blocks);
  for (; found.blocks < blocks; ++found.blocks) {
    const double second = static_cast<double>(found.blocks) / kBlocksASecond;
    if (second >= kReloadEvery_s * static_cast<double>(reloads + 1))
      engine = std::make_unique<Engine>(soak_options(seed + ++reloads), tools::formula_sounds());
    engine->process(shift.at(second), block.data());
    float loudest = 0;
    for (const float x : block) {
      found.not_finite += std::isfinite(x) ? 0 : 1;
      loudest = std::max(loudest, std::fabs(x));
      eighth.sum += static_cast<double>(x);
      eighth.energy += static_cast<double>(x) * static_cast<double>(x);
    }
    eighth.samples += static_cast<double>(block.size());
    found.peak = std::max(found.peak, static_cast<double>(loudest));
    found.over_ceiling += static_cast<double>(loudest) > ceiling ? 1 : 0;
    if (loudest > 0) found.repeated += seen.insert(hash_of(block)).second ? 0 : 1;
    if (shift.steady())
      loops.add(block.data(), options.channels);
    else if (loops.any())
      found.most_alike = std::max(found.most_alike, loops.finish());
    if ((found.blocks + 1) % (blocks / 8) == 0) {
      const double dc = eighth.sum / eighth.samples;
      found.most_dc = std::max(found.most_dc, std::fabs(dc));
      if (figures != nullptr)
        std::fprintf(figures, "FIGURE soak at %.2f h: %.2f dBFS rms, DC %.1e, %.0f MB\n", second / 3600,
                     10 * std::log10(eighth.energy / eighth.samples), dc, memory_mb());
      eighth = {};
    }
  }
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  const double hours = argc > 1 ? std::atof(argv[1]) : 0;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  if (hours <= 0 || hours > 1000) {
    std::fprintf(stderr, "offline_soak HOURS [SEED]: expected 0...1000 hours\n");
    return 2;
  }
  soak(0.02, seed, nullptr);  // what is allocated once
  const double before_mb = memory_mb();
  const Found f = soak(hours, seed, stdout);
  const double table_mb = static_cast<double>(f.blocks) * 40e-6;  // of the blocks seen
  const double grown_mb = memory_mb() - before_mb;
  std::printf(
      "FIGURE soak: %.2f h, %llu blocks, %llu not finite, %llu over the ceiling, %llu repeated, peak %.2f "
      "dBFS, "
      "most alike after 0.5...10 s %.2f, %.1f MB grown\n",
      hours, static_cast<unsigned long long>(f.blocks), static_cast<unsigned long long>(f.not_finite),
      static_cast<unsigned long long>(f.over_ceiling), static_cast<unsigned long long>(f.repeated),
      20 * std::log10(f.peak), f.most_alike, grown_mb);
  const bool good = f.not_finite == 0 && f.over_ceiling == 0 && f.repeated == 0 && f.most_dc < kMostDc &&
                    f.most_alike < kMostAlike && grown_mb < kMostGrowth_mb + table_mb;
  return good ? 0 : 1;
}
