#include "simulate/diesel_recording.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/diesel_model.hpp"
#include "simulate/biquad_cascade.hpp"
#include "simulate/diesel_body.hpp"
#include "simulate/split_mix.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kCylinders = 6, kTicks = 12, kPumpOrder = 18, kGearOrder = 94;
constexpr double kDegree = 1.0 / 720, kPulse = 11 * kDegree, kLevel = 0.12;
constexpr std::uint64_t kDieselSeed = 77;

using Wave = std::vector<double>;

/// What makes this diesel this one: cylinders and ticks differ, always in the same way.
struct SimulatedDiesel {
  SimulatedDiesel() {
    SplitMix draw(kDieselSeed);
    for (double& g : strength) g = 1 + 0.15 * draw.normal();
    for (double& t : timing) t = 0.8 * kDegree * draw.normal();
    for (double& a : tick_angle) a = draw.uniform();
    for (double& g : tick_strength) g = draw.uniform(0.3, 1);
  }
  double strength[kCylinders], timing[kCylinders], tick_angle[kTicks], tick_strength[kTicks];
};

/// Unit variance, nothing faster than about `bandwidth_hz`.
Wave slow(SplitMix& draw, std::size_t samples, double rate, double bandwidth_hz) {
  const auto knots = static_cast<std::size_t>(static_cast<double>(samples) / rate * bandwidth_hz * 8) + 16;
  const Wave white = draw.normals(knots + 8);
  Wave knot(knots);
  double power = 0;
  for (std::size_t i = 0; i < knots; ++i) {
    for (std::size_t j = 0; j < 9; ++j)
      knot[i] += white[i + j] * (0.5 - 0.5 * std::cos(2 * M_PI * (static_cast<double>(j) + 1) / 10));
    power += knot[i] * knot[i] / static_cast<double>(knots);
  }
  Wave y(samples);
  for (std::size_t n = 0; n < samples; ++n) {
    const double at = static_cast<double>(n) / static_cast<double>(samples) * static_cast<double>(knots - 1);
    const auto i = static_cast<std::size_t>(at);
    y[n] = (knot[i] + (knot[i + 1] - knot[i]) * (at - static_cast<double>(i))) / std::sqrt(power);
  }
  return y;
}

/// Unit variance, 1/f from 1.5 Hz up: first-order noises an octave apart.
Wave pink(SplitMix& draw, std::size_t samples) {
  Wave sum(samples);
  constexpr int kOctaves = 12;
  for (int octave = 0; octave < kOctaves; ++octave) {
    const double pole = std::exp(-2 * M_PI * 1.5 * std::pow(2, octave) / kAnalysisRate);
    const double gain = std::sqrt((1 - pole * pole) / kOctaves);
    double state = draw.normal() / std::sqrt(static_cast<double>(kOctaves));
    for (double& v : sum) v += state = pole * state + gain * draw.normal();
  }
  return sum;
}

Wave crank_angle(const DieselRun& run, SplitMix& draw, Wave& rpm) {
  const Wave wander = slow(draw, run.rpm.size(), kAnalysisRate, 1.0);
  Wave theta(run.rpm.size());
  rpm.resize(theta.size());
  double angle = draw.uniform();
  for (std::size_t n = 0; n < theta.size(); ++n) {
    rpm[n] = run.rpm[n] * (1 + run.wander * wander[n]);
    theta[n] = angle += cycles_per_second(rpm[n]) / kAnalysisRate;
  }
  return theta;
}

/// The sample (fractional) at which the crank reaches `angle`; negative when it does not.
double sample_at(const Wave& theta, double angle) {
  if (angle < theta.front() || angle >= theta.back()) return -1;
  const auto upper = std::upper_bound(theta.begin(), theta.end(), angle);
  const double a = *(upper - 1), b = *upper;
  return static_cast<double>(upper - theta.begin()) - 1 + (angle - a) / (b - a);
}

struct Combustion {
  Wave pulses, bursts;
};

Combustion combustion(const DieselRun& run, const SimulatedDiesel& machine, const Wave& theta,
                      SplitMix& draw) {
  Combustion c{Wave(theta.size()), Wave(theta.size())};
  const auto first = static_cast<long>(std::floor(theta.front() * kCylinders)) - 2;
  const auto last = static_cast<long>(std::ceil(theta.back() * kCylinders)) + 1;
  const Wave hunting = slow(draw, static_cast<std::size_t>(last - first), 1, 0.02);
  for (long k = first; k < last; ++k) {
    const auto cylinder = static_cast<std::size_t>((k % kCylinders + kCylinders) % kCylinders);
    const double strength = (0.4 + 1.2 * run.load) * machine.strength[cylinder] *
                            (1 + 0.04 * hunting[k - first]) * (1 + 0.06 * draw.normal());
    const double loud = (0.25 + 0.9 * run.load) * std::exp(0.4 * draw.normal());
    const double angle =
        static_cast<double>(k) / kCylinders + machine.timing[cylinder] + 0.4 * kDegree * draw.normal();
    const double at = sample_at(theta, angle);
    if (at < 0) continue;
    const auto start = static_cast<std::size_t>(at) + 1;
    for (std::size_t n = start; n < theta.size() && theta[n] - angle < 0.16; ++n) {
      const double phase = (theta[n] - angle) / kPulse;
      c.pulses[n] += strength * phase * std::exp(1 - phase);
    }
    for (std::size_t n = start; n < std::min(theta.size(), start + 960); ++n) {
      const double t = (static_cast<double>(n) - at) / kAnalysisRate;
      c.bursts[n] += loud * std::exp(-t / 0.0025) * (1 - std::exp(-t / 0.0001));
    }
  }
  return c;
}

void add_ticks(const SimulatedDiesel& machine, const Wave& theta, SplitMix& draw, double gain, Wave& x) {
  for (int j = 0; j < kTicks; ++j)
    for (auto cycle = static_cast<long>(theta.front()) - 1; cycle <= static_cast<long>(theta.back());
         ++cycle) {
      const double at = sample_at(theta, static_cast<double>(cycle) + machine.tick_angle[j]);
      const double strength = machine.tick_strength[j] * (1 + 0.15 * draw.normal());
      if (at < 0) continue;
      const auto start = static_cast<std::size_t>(at) + 1;
      for (std::size_t n = start; n < std::min(x.size(), start + 150); ++n) {
        const double t = (static_cast<double>(n) - at) / kAnalysisRate;
        x[n] += gain * strength * std::exp(-t / 0.0004) * std::sin(2 * M_PI * 3300 * t);
      }
    }
}

/// Lines locked to the crank whose levels vary like 1/f.
void add_lines(const Wave& theta, SplitMix& draw, Wave& x) {
  struct Line {
    int order;
    double level, depth, jitter;
  };
  constexpr Line kLines[] = {{kPumpOrder, 0.10, 0.35, 0.25},     {2 * kPumpOrder, 0.08, 0.35, 0.25},
                             {3 * kPumpOrder, 0.05, 0.35, 0.25}, {4 * kPumpOrder, 0.03, 0.35, 0.25},
                             {kGearOrder, 0.04, 0.3, 0},         {2 * kGearOrder, 0.02, 0, 0}};
  for (const Line& line : kLines) {
    const Wave level = pink(draw, x.size()), phase = slow(draw, x.size(), kAnalysisRate, 0.5);
    for (std::size_t n = 0; n < x.size(); ++n)
      x[n] += line.level * (1 + line.depth * level[n]) *
              std::sin(2 * M_PI * line.order * theta[n] + 0.07 * line.order + line.jitter * phase[n]);
  }
}

}  // namespace

DieselRecording simulate_diesel(const DieselRun& run) {
  static const SimulatedDiesel machine;
  SplitMix draw(run.seed);
  DieselRecording recording;
  recording.theta = crank_angle(run, draw, recording.rpm);
  const Wave& theta = recording.theta;
  Combustion c = combustion(run, machine, theta, draw);

  Wave burst_noise = draw.normals(theta.size()), flow = draw.normals(theta.size());
  filter({highpass(500), one_pole(9000)}, burst_noise);
  filter({highpass(150, 0.5), one_pole(6000)}, flow);
  Wave source(theta.size());
  double before = 0;
  for (std::size_t n = 0; n < source.size(); ++n) {
    const double slope = (c.pulses[n] - before) * kAnalysisRate / 1500;
    before = c.pulses[n];
    source[n] = 0.9 * c.pulses[n] + 0.5 * slope + 1.2 * burst_noise[n] * c.bursts[n] +
                flow[n] * (0.10 + 0.08 * run.rpm[n] / 1500);
  }
  add_ticks(machine, theta, draw, 0.25, source);
  add_lines(theta, draw, source);
  recording.sound = through_body(source);
  for (double& v : recording.sound) v *= kLevel;
  return recording;
}

std::vector<double> steady_rpm(double rpm, double seconds) {
  return std::vector<double>(static_cast<std::size_t>(seconds * kAnalysisRate), rpm);
}

std::vector<double> ramp_rpm(double from, double to, double seconds) {
  std::vector<double> rpm(static_cast<std::size_t>(seconds * kAnalysisRate));
  for (std::size_t n = 0; n < rpm.size(); ++n)
    rpm[n] = from + (to - from) * static_cast<double>(n) / static_cast<double>(rpm.size());
  return rpm;
}

std::vector<double> glide_rpm(double from, double to, double seconds) {
  std::vector<double> rpm = ramp_rpm(std::log(from), std::log(to), seconds);
  for (double& r : rpm) r = std::exp(r);
  return rpm;
}

}  // namespace rigsound::analysis
