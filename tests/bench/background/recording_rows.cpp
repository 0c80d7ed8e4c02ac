// A real engine: its likeness, and whether it ever repeats.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "background/learning.hpp"
#include "background/table.hpp"
#include "diesel/angle_domain.hpp"
#include "diesel/compared_cycles.hpp"
#include "diesel/hbwt.hpp"
#include "note/subband_noise.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/dsp/fft.hpp"

namespace rigsound::bench {
namespace {

using namespace rigsound::analysis;
namespace fs = std::filesystem;

constexpr double kIdle_rpm = 799;  // 26.63 firings a second, four a cycle
constexpr double kEndless_s = 180;
constexpr int kGrains = 48;
constexpr double kValleys_hz[] = {250, 1000};

/// The paper's model of the whole engine: L = 1, one energy a subband, harmonics by their mean.
CyclicSound paper_model(const CyclicSound& recorded, int N) {
  HbwtCoefficients<double> c = hbwt(recorded.y, {recorded.N, 1, N});
  std::mt19937_64 chance(1);
  const auto columns = static_cast<std::size_t>(recorded.N);
  const auto replace = [&](std::vector<double>& rows, bool harmonics) {
    for (std::size_t q = 0; q < columns; ++q) {
      Subband channel;
      for (std::size_t i = q; i < rows.size(); i += columns) channel.push_back(rows[i]);
      double mean = 0;
      if (harmonics)
        for (const double v : channel) mean += v / static_cast<double>(channel.size());
      for (double& v : channel) v -= mean;
      const Subband noise = noise_like(channel, {power_of(channel), 0, 0}, chance);
      for (std::size_t i = 0; i < noise.size(); ++i) rows[i * columns + q] = mean + noise[i];
    }
  };
  for (auto& d : c.d) replace(d, false);
  replace(c.a, true);
  return {inverse_hbwt(c), recorded.N, recorded.f0};
}

/// Largest correlation of the noise (mean cycle taken off, 0.5 ... 6 kHz) with itself more than 1 s later.
double loop_correlation(const CyclicSound& s) {
  const auto N = static_cast<std::size_t>(s.N);
  const std::size_t cycles = s.y.size() / N;
  std::vector<double> mean(N, 0.0), noise = s.y;
  for (std::size_t i = 0; i < cycles * N; ++i) mean[i % N] += s.y[i] / static_cast<double>(cycles);
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] -= mean[i % N];
  const double rate = s.N * s.f0;
  noise = zero_phase_low_pass(zero_phase_high_pass(noise, 500, rate), 6000, rate);
  std::size_t size = 1;
  while (size < 2 * noise.size()) size *= 2;
  std::vector<double> re = noise, im(size, 0.0);
  re.resize(size, 0.0);
  const dsp::Fft<double> fft(static_cast<int>(size));
  fft.forward(re.data(), im.data());
  for (std::size_t i = 0; i < size; ++i) re[i] = re[i] * re[i] + im[i] * im[i], im[i] = 0;
  fft.inverse(re.data(), im.data());
  double worst = 0;
  for (auto lag = static_cast<std::size_t>(rate); lag < noise.size() * 3 / 4; ++lag) {
    const double share = static_cast<double>(noise.size()) / static_cast<double>(noise.size() - lag);
    worst = std::max(worst, std::fabs(re[lag] / re[0] * share));
  }
  return worst;
}

/// Standard deviation of the level of stretches of 10 s, dB.
double level_drift(const std::vector<float>& x) {
  const auto length = static_cast<std::size_t>(10 * kAnalysisRate);
  std::vector<double> db;
  for (std::size_t at = 0; at + length <= x.size(); at += length) {
    double power = 0;
    for (std::size_t n = at; n < at + length; ++n)
      power += static_cast<double>(x[n]) * static_cast<double>(x[n]);
    db.push_back(10 * std::log10(power));
  }
  double mean = 0, square = 0;
  for (const double v : db) mean += v / static_cast<double>(db.size());
  for (const double v : db) square += (v - mean) * (v - mean) / static_cast<double>(db.size());
  return std::sqrt(square);
}

struct Bounds {
  std::string name;
  double third_octave, envelope, modulation, correlation;
};

/// What the picture of the spectrum shows: valleys between its lines, and lines that stand out of them.
void valley_rows(Table& table, const std::string& name, const CyclicSound& played,
                 const CyclicSound& recorded) {
  const auto depth = [](const CyclicSound& s, int fraction, std::size_t group) {
    return valley_depth(fractional_octaves(s, fraction, kValleys_hz[0], kValleys_hz[1]), group);
  };
  table.note("idle, recorded: depth of third-octave valleys, 250...1000 Hz", depth(recorded, 3, 3), "dB");
  table.note("idle, " + name + ": depth of third-octave valleys", depth(played, 3, 3), "dB");
  table.note("idle, recorded: depth of 1/24-octave valleys, 250...1000 Hz", depth(recorded, 24, 8), "dB");
  table.note("idle, " + name + ": depth of 1/24-octave valleys", depth(played, 24, 8), "dB");
  const StandingOrders orders = standing_orders(played, recorded, 300, 1000);
  table.note("idle, recorded: orders 10 dB over their floor, 300...1000 Hz", orders.count, "");
  table.note("idle, " + name + ": they stand lower by", orders.lost_db, "dB");
}

/// The rows of one way to play the high layer; returns the cyclic envelope's error.
double model_rows(Table& table, const DieselTake& take, const DieselModel& model, const Bounds& bounds) {
  const DieselPoint& point = model.points.front();
  const double highest = std::min(9000.0, 0.45 * take.source_rate);
  const CyclicSound recorded = recorded_cycles(section_of(take), point, model.angle_samples);
  const int cycles = static_cast<int>(recorded.y.size()) / recorded.N;
  const CyclicSound played = played_cycles(model, point, cycles, 1);
  const Likeness l = likeness(played, recorded, highest);
  table.at_most("idle, " + bounds.name + ": third-octave", bounds.third_octave, l.third_octave_db, "dB");
  table.at_most("idle, " + bounds.name + ": cyclic envelope", bounds.envelope, l.cyclic_envelope_db, "dB");
  table.at_most("idle, " + bounds.name + ": modulation spectrum", bounds.modulation, l.modulation_db, "dB");
  valley_rows(table, bounds.name, played, recorded);
  const CyclicSound endless =
      played_cycles(model, point, static_cast<int>(kEndless_s * cycles_per_second(point.rpm)), 2);
  table.at_most("180 s, " + bounds.name + ": autocorrelation beyond 1 s", bounds.correlation,
                loop_correlation(endless), "");
  const std::vector<double> steady(static_cast<std::size_t>(kEndless_s * kAnalysisRate), point.rpm);
  table.at_most("180 s, " + bounds.name + ": level drift", 0.2,
                level_drift(play_diesel(model, steady, point.load, 0, 3)), "dB");
  return l.cyclic_envelope_db;
}

}  // namespace

void recording_rows(Table& table, const fs::path& data) {
  const fs::path file = data / "engine/idle_26.63hz.wav";
  if (!fs::exists(file)) return table.skip("the real idle", file.string() + " is not there");
  const Recording recording = read_recording(file);
  DieselTake take;
  take.source = file.string(), take.mono = recording.mono, take.source_rate = recording.source_rate;
  take.rpm = kIdle_rpm;
  DieselSettings settings;
  settings.name = "idle";
  const DieselModel slots = learn_diesel({take}, settings).model;
  const double envelope = model_rows(table, take, slots, {"parametric", 0.9, 0.95, 3.0, 0.02});

  const DieselPoint& point = slots.points.front();
  const CyclicSound recorded = recorded_cycles(section_of(take), point, slots.angle_samples);
  const Likeness paper = likeness(paper_model(recorded, slots.low_scales), recorded, 9000);
  table.note("idle, the paper's L = 1: cyclic envelope", paper.cyclic_envelope_db, "dB");
  table.at_least("idle, L = 1 over parametric: cyclic envelope", 2, paper.cyclic_envelope_db / envelope, "");

  settings.grains = kGrains;
  model_rows(table, take, learn_diesel({take}, settings).model, {"48 grains", 0.8, 0.55, 1.8, 0.10});

  const auto parameters = static_cast<double>(parameter_count(slots));
  table.at_most("size of the bank", 48, 4 * parameters / 1000, "kB");
  table.at_least("samples a parameter", 60, static_cast<double>(take.mono.size()) / parameters, "");
}

}  // namespace rigsound::bench
