#include "rigsound/default_diesel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/linear_prediction.hpp"

namespace rigsound {
namespace {

constexpr int kCylinders = 6;
constexpr double kStrength[kCylinders] = {1.00, 0.91, 1.08, 0.96, 1.05, 0.88};  // no two cylinders are alike
constexpr double kPulse = 11.0 / 720;  // width of a firing pulse, cycles
constexpr double kLevel = 0.021;       // makes the idle about -30 dBFS

struct Resonance {
  double f_hz, q, gain;
};
constexpr Resonance kBody[] = {{62, 6, 1.0},    {118, 7, 0.9},   {185, 8, 0.9},  {310, 9, 0.6},
                               {455, 10, 0.55}, {690, 12, 0.45}, {980, 12, 0.5}, {1430, 14, 0.4},
                               {2050, 12, 0.4}, {2900, 10, 0.3}, {4300, 8, 0.2}, {7000, 3, 0.1}};

/// Power response of the body at f: its resonances side by side over a small direct part.
double body_power(double f) {
  double re = 0.06, im = 0;
  for (const Resonance& r : kBody) {
    const double detune = r.q * (f / r.f_hz - r.f_hz / f), norm = 1 + detune * detune;
    re += r.gain / norm;
    im -= r.gain * detune / norm;
  }
  return re * re + im * im;
}

BodyResponse body_response() {
  BodyResponse E;
  for (double f = E.f_min; f < 2500;
       f = E.f_min * dsp::exp(dsp::kLn2 * static_cast<double>(E.db.size()) / E.per_octave))
    E.db.push_back(static_cast<float>(10 / dsp::kLn10 * dsp::log(body_power(f))));
  return E;
}

/// The same body as a filter, over the crossover.
std::vector<float> body_filter(double sample_rate, double f_x) {
  constexpr int kOrder = 48, kBins = 2048;
  std::vector<double> r(kOrder + 1, 0.0);
  for (int bin = 0; bin < kBins; ++bin) {
    const double f = (bin + 0.5) / kBins * sample_rate / 2;
    const double power = body_power(std::max(f, f_x)) + 1e-5;
    const double first = dsp::cos(dsp::kTwoPi * f / sample_rate);
    double cosine = 1, before = first;  // cos (n + 1) x = 2 cos x cos n x - cos (n - 1) x
    for (double& sum : r) {
      sum += power * cosine;
      before = std::exchange(cosine, 2 * first * cosine - before);
    }
  }
  const std::vector<double> a = dsp::levinson(r).a;
  return {a.begin(), a.end()};
}

/// Spectrum of six pulses A (t / w) exp(1 - t / w): each has A w e / (1 + i 2 pi k w)^2.
std::vector<std::complex<float>> orders(double rpm) {
  std::vector<std::complex<float>> C;
  const double f = cycles_per_second(rpm);
  const int last = static_cast<int>(std::min(2000.0 / f, 400.0));
  for (int k = 1; k <= last; ++k) {
    const double x = dsp::kTwoPi * k * kPulse, magnitude = 1 / (1 + x * x), bend = -2 * dsp::atan(x);
    double re = 0, im = 0;
    for (int c = 0; c < kCylinders; ++c) {
      const double angle = bend - dsp::kTwoPi * k * c / kCylinders;
      re += kStrength[c] * dsp::cos(angle), im += kStrength[c] * dsp::sin(angle);
    }
    const double gain = kLevel * magnitude * std::sqrt(body_power(k * f));
    C.emplace_back(static_cast<float>(gain * re), static_cast<float>(gain * im));
  }
  return C;
}

DieselPoint point(const DieselModel& model, double rpm) {
  DieselPoint p;
  p.source = "formula";
  p.rpm = rpm;
  p.orders = orders(rpm);
  for (int n = 1; n <= model.low_scales + 1;
       ++n)  // 1/f around every order: each scale nearer holds twice the density
    for (int q = 0; q < model.low_channels; ++q) {
      const double f = (q + 0.5) / 2 * cycles_per_second(rpm);
      const double slope = 1 / (1 + (f / 90) * (f / 90));
      p.low_variance.push_back(
          static_cast<float>(1.2e-4 * slope * body_power(f) * dsp::exp(dsp::kLn2 * 0.7 * (n - 1))));
    }
  const std::size_t bands = slot_band_edges(model.slot_samples()).size() - 1;
  for (int l = 0; l < model.slots; ++l) {
    const double firing =
        static_cast<double>(l * kCylinders % model.slots) / model.slots;  // 0...1 from one to the next
    const double strength = kStrength[l * kCylinders / model.slots];
    const double burst = strength * strength * dsp::exp(-firing / 0.12);
    const double speed = rpm / 1500;
    const double sigma2 = 5e-5 * (0.35 * speed * speed + 2.2 * burst);
    p.slot_variance.insert(p.slot_variance.end(), bands, static_cast<float>(sigma2));
    p.slot_log_variance.push_back(static_cast<float>(0.15 + 0.35 * burst));
  }
  p.slot_correlation = 0.4;
  return p;
}

HydraulicPart hydraulics() {
  HydraulicPart part;
  part.pump = {0.006F, 0.0035F, 0.0022F, 0.0012F, 0.0007F};
  part.flow = 0.012;
  part.flow_filter = {1.0F, -1.25F, 0.36F};  // two real poles: hiss that falls off above 2 kHz
  return part;
}

}  // namespace

DieselModel default_diesel() {
  DieselModel model;
  model.name = kDefaultDiesel;
  model.body = body_response();
  model.body_filter = body_filter(model.sample_rate, model.crossover_hz);
  model.hydraulic = hydraulics();
  for (const double rpm : {700.0, 1300.0, 2300.0}) model.points.push_back(point(model, rpm));
  return model;
}

}  // namespace rigsound
