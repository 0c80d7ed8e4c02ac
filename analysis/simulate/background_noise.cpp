#include "simulate/background_noise.hpp"

#include <cmath>
#include <complex>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/diesel_model.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "simulate/biquad_cascade.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kOrders = 180;
constexpr std::size_t kHydraulicSettle = 4096;  // samples the hydraulic filter runs in

using Phasor = std::complex<double>;

void to_unit_power(std::vector<double>& x) {
  double energy = 0;
  for (const double v : x) energy += v * v;
  const double scale = 1 / std::sqrt(energy / static_cast<double>(x.size()));
  for (double& v : x) v *= scale;
}

std::size_t frames_of(double seconds) {
  return static_cast<std::size_t>(std::nearbyint(seconds * kAnalysisRate));
}

std::vector<double> crank_angle(const BackgroundScene& scene) {
  std::vector<double> phi(scene.cycles_hz.size());
  double cycles = 0;
  for (std::size_t n = 0; n < phi.size(); ++n) {
    cycles += scene.cycles_hz[n];
    phi[n] = dsp::kTwoPi * cycles / kAnalysisRate;
  }
  return phi;
}

/// One order of the engine: its phasor at crank angle zero and the slow swell of its level.
struct Order {
  Phasor start, swell, swell_turn;
};

std::vector<Order> draw_orders(SplitMix& stream) {
  const std::vector<double> level = stream.normals(kOrders), phase = stream.uniforms(kOrders),
                            swell_hz = stream.uniforms(kOrders), swell_phase = stream.uniforms(kOrders);
  std::vector<Order> orders(kOrders);
  for (int k = 0; k < kOrders; ++k) {
    const int h = k + 1;
    const double firing = h % 6 == 0 ? 3 : 1;  // six cylinders fire once each per cycle
    const double amplitude = std::pow(h, -0.8) * std::pow(10, level[k] * 5 / 20) * firing;
    orders[k].start = std::polar(amplitude, dsp::kTwoPi * phase[k]);
    orders[k].swell = std::polar(1.0, dsp::kTwoPi * swell_phase[k]);
    orders[k].swell_turn = std::polar(1.0, dsp::kTwoPi * (0.2 + 0.6 * swell_hz[k]) / kAnalysisRate);
  }
  return orders;
}

std::vector<double> diesel(const std::vector<double>& phi, SplitMix& stream) {
  std::vector<Order> orders = draw_orders(stream);
  std::vector<double> e(phi.size(), 0.0);
  for (std::size_t n = 0; n < phi.size(); ++n) {
    const Phasor crank = std::polar(1.0, phi[n]);
    Phasor power(1, 0);  // crank to the h-th
    double sum = 0;
    for (Order& o : orders) {
      power *= crank;
      sum += (1 + 0.15 * o.swell.imag()) * (power.real() * o.start.real() - power.imag() * o.start.imag());
      o.swell *= o.swell_turn;
    }
    e[n] = sum;
  }
  to_unit_power(e);
  return e;
}

std::vector<double> hydraulics(std::size_t frames, SplitMix& stream, SplitMix& noise) {
  BiquadCascade colour{one_pole(stream.log_uniform(500, 1500))};
  for (int i = 0; i < 3; ++i) {
    const double f = stream.log_uniform(300, 6000), gain_db = stream.uniform(6, 12),
                 q = stream.log_uniform(2, 6);
    colour.push_back(peaking(f, gain_db, q));
  }
  std::vector<double> x = noise.normals(frames + kHydraulicSettle);
  filter(colour, x);
  x.erase(x.begin(), x.begin() + kHydraulicSettle);
  to_unit_power(x);
  const double swell_hz = stream.uniform(.15, .35), swell_phase = dsp::kTwoPi * stream.uniform();
  for (std::size_t n = 0; n < frames; ++n) {
    const double t = static_cast<double>(n) / kAnalysisRate;
    x[n] *= std::pow(10, 1.5 * std::sin(dsp::kTwoPi * swell_hz * t + swell_phase) / 20);
  }
  return x;
}

std::vector<double> pump_whine(const std::vector<double>& phi, SplitMix& stream) {
  constexpr double kAmplitudes[] = {1.0, 0.6, 0.4};
  const double ratio = stream.uniform(14, 22);
  std::vector<double> x(phi.size(), 0.0);
  for (int k = 1; k <= 3; ++k) {
    const double phase = dsp::kTwoPi * stream.uniform();
    for (std::size_t n = 0; n < x.size(); ++n)
      x[n] += kAmplitudes[k - 1] * std::cos(k * ratio * phi[n] + phase);
  }
  to_unit_power(x);
  return x;
}

}  // namespace

BackgroundScene BackgroundScene::drawn(double seconds, SplitMix& stream) {
  const double cycles = stream.uniform(12, 18);
  const double slow_hz = stream.uniform(.1, .3), fast_hz = stream.uniform(.3, .7);
  const double slow_phase = dsp::kTwoPi * stream.uniform(), fast_phase = dsp::kTwoPi * stream.uniform();
  BackgroundScene scene;
  scene.cycles_hz.resize(frames_of(seconds));
  for (std::size_t n = 0; n < scene.cycles_hz.size(); ++n) {
    const double t = static_cast<double>(n) / kAnalysisRate;
    scene.cycles_hz[n] = cycles * (1 + 0.03 * std::sin(dsp::kTwoPi * slow_hz * t + slow_phase) +
                                   0.015 * std::sin(dsp::kTwoPi * fast_hz * t + fast_phase));
  }
  return scene;
}

BackgroundScene BackgroundScene::ramp(double seconds, double rpm_start, double rpm_end) {
  constexpr double kWanderHz = 0.23;
  BackgroundScene scene;
  scene.cycles_hz.resize(frames_of(seconds));
  for (std::size_t n = 0; n < scene.cycles_hz.size(); ++n) {
    const double t = static_cast<double>(n) / kAnalysisRate;
    const double rpm = rpm_start + (rpm_end - rpm_start) * t / seconds;
    scene.cycles_hz[n] = cycles_per_second(rpm) * (1 + 0.01 * std::sin(dsp::kTwoPi * kWanderHz * t));
  }
  return scene;
}

std::vector<double> background_noise(const BackgroundScene& scene, SplitMix& structure, SplitMix& noise) {
  const std::vector<double> phi = crank_angle(scene);
  std::vector<double> sum = diesel(phi, structure);
  const std::vector<double> oil = hydraulics(phi.size(), structure, noise),
                            whine = pump_whine(phi, structure);
  const double whine_gain = std::pow(10, -10.0 / 20), floor_gain = std::pow(10, -25.0 / 20);
  for (std::size_t n = 0; n < sum.size(); ++n)
    sum[n] += oil[n] + whine_gain * whine[n] + floor_gain * noise.normal();
  to_unit_power(sum);
  return sum;
}

}  // namespace rigsound::analysis
