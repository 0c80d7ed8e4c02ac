#include <algorithm>
#include <cmath>
#include <vector>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/steel.hpp"
#include "rigsound/string_model.hpp"
#include "string/bending_modes.hpp"
#include "string/design/string_tuning.hpp"
#include "tool/design/mode_law.hpp"

namespace rigsound {
namespace {

using namespace string;

constexpr double kHighestLongitudinal_hz = 6000;
constexpr double kLn1000 = 3 * dsp::kLn10;

/// A piece of the string: its impedance, and how long a wave takes through it, samples.
struct Section {
  double impedance, delay;
};

/// Force at the bit of a string whose shank end is free and moves with unit speed: zero at a mode of the free
/// string.
double force_at_bit(const std::vector<Section>& sections, double omega) {
  double force = 0, speed = 1;
  for (const Section& s : sections) {
    const double c = dsp::cos(omega * s.delay), sine = dsp::sin(omega * s.delay);
    const double passed = c * force + s.impedance * sine * speed;
    speed = c * speed - sine / s.impedance * force;
    force = passed;
  }
  return force;
}

std::vector<Section> exact_sections(const StringModel& model, double sample_rate) {
  const auto delay = [&](double length_m) { return round_trip_samples(length_m, sample_rate) / 2; };
  const bool has_shank = model.shank_length_m > 0;
  const int joints = has_shank ? model.rods : model.rods - 1;
  std::vector<Section> sections;
  for (int j = 0; j <= joints; ++j) {
    const double covered = ((j > 0 ? 0.5 : 0) + (j < joints ? 0.5 : 0)) * model.sleeve_length_m;
    const double length = j == 0 && has_shank ? model.shank_length_m : model.rod_length_m;
    if (j > 0) sections.push_back({model.sleeve_impedance, delay(model.sleeve_length_m)});
    sections.push_back({1, delay(length - covered)});
  }
  return sections;
}

/// Lag of the Thiran allpass, samples: that of z^-2 and twice that of its denominator's conjugate.
double phase_delay(const Thiran& s, double omega) {
  const double re = 1 + s.a1 * dsp::cos(omega) + s.a2 * dsp::cos(2 * omega);
  const double im = s.a1 * dsp::sin(omega) + s.a2 * dsp::sin(2 * omega);
  return 2 - 2 * dsp::atan2(im, re) / omega;
}

/// The same of the rods' interpolator.
double phase_delay(const Lagrange& s, double omega) {
  const double re = s.tap[1] + (s.tap[0] + s.tap[2]) * dsp::cos(omega);
  const double im = (s.tap[2] - s.tap[0]) * dsp::sin(omega);
  return 1 + dsp::atan2(im, re) / omega;
}

std::vector<Section> played_sections(const StringTuning& tuning, double omega) {
  std::vector<Section> sections;
  for (int j = 0; j <= tuning.joints; ++j) {
    const double beyond = j == 0                 ? 1 + phase_delay(thiran(tuning.head_delay), omega)
                          : tuning.has_fractions ? phase_delay(lagrange(tuning.fraction[j]), omega)
                                                 : 0;
    if (j > 0) sections.push_back({tuning.sleeve_impedance, tuning.sleeve_steps * kSleeveStep / 2.0});
    sections.push_back({1, (tuning.delay[j] + beyond) / 2});
  }
  return sections;
}

/// Every sign change of `f` between two steps, by bisection, rad/sample.
template <class Function>
std::vector<double> roots(const Function& f, double step, double highest) {
  std::vector<double> found;
  double before = f(step / 3);
  for (double at = step / 3; at < highest; at += step) {
    const double after = f(at + step);
    if (before * after < 0) {
      double low = at, high = at + step;
      for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (f(middle) * before > 0 ? low : high) = middle;
      }
      found.push_back((low + high) / 2);
    }
    before = after;
  }
  return found;
}

double cents(double a, double b) { return 1200 / dsp::kLn2 * dsp::log(a / b); }

/// Decay of a free string: what a round trip loses at the shank, and to the rods' fractions of a sample.
double string_t60_s(const StringTuning& tuning, double omega, double sample_rate) {
  double log_gain = dsp::log(tuning.loss_middle + 2 * tuning.loss_side * dsp::cos(omega));
  for (int j = 1; j <= tuning.joints; ++j) {
    const double d2 = tuning.fraction[j] * tuning.fraction[j], rest = 1 - dsp::cos(omega);
    log_gain += dsp::log(1 - d2 * (1 - d2) * rest * rest) / 2;
  }
  return kLn1000 * tuning.round_trip() / (-log_gain * sample_rate);
}

void add_longitudinal(const StringModel& model, double sample_rate, std::vector<StringMode>& modes) {
  const StringTuning tuning = tune_string(model, model.rods, sample_rate);
  const std::vector<Section> exact = exact_sections(model, sample_rate);
  const double to_omega = dsp::kTwoPi / sample_rate, highest = kHighestLongitudinal_hz * to_omega;
  const double step = dsp::kPi / tuning.round_trip() / 30;
  const auto wanted = roots([&](double w) { return force_at_bit(exact, w); }, step, highest);
  const auto played =
      roots([&](double w) { return force_at_bit(played_sections(tuning, w), w); }, step, 1.05 * highest);
  const std::size_t count = std::min(wanted.size(), played.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double free_s = string_t60_s(tuning, played[i], sample_rate);
    const double pressed_s = 1 / (1 / free_s + 1 / model.guided_s);
    modes.push_back({"longitudinal", static_cast<int>(i) + 1, wanted[i] / to_omega, played[i] / to_omega,
                     cents(played[i], wanted[i]), free_s, pressed_s});
  }
}

void add_bending(const StringModel& model, double exposed_m, double sample_rate,
                 std::vector<StringMode>& modes) {
  const tool::TransversalLaw law(Bar{exposed_m, model.rod_diameter_m});
  BendingModes bank(model, sample_rate, dsp::widest_lanes()), pressed = bank;
  bank.set(exposed_m, 0);
  bank.retune();
  pressed.set(exposed_m, 1);
  pressed.retune();
  for (int k = 1; k <= kMaxModes && law.at(k) < kFadeTo_hz; ++k) {
    const double model_hz = bank.frequency_hz(k);
    modes.push_back(
        {"bending", k, law.at(k), model_hz, cents(model_hz, law.at(k)), bank.t60_s(k), pressed.t60_s(k)});
  }
}

}  // namespace

std::vector<StringMode> string_modes(const StringModel& model, double exposed_m, double sample_rate) {
  require_valid(model);
  std::vector<StringMode> modes;
  add_longitudinal(model, sample_rate, modes);
  add_bending(model, exposed_m, sample_rate, modes);
  return modes;
}

}  // namespace rigsound
