// Where the energy of a blow goes on its way down the string and back.
#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/steel.hpp"
#include "rigsound/string_model.hpp"

namespace rigsound {
namespace {

constexpr int kPulseSamples = 64;      // of the Hann pulse, finer than any grid it is played on
constexpr int kSpectrumPoints = 512;   // of its spectrum
constexpr double kSpectrumWidths = 8;  // where the spectrum ends, in 1 / width: 1e-9 of the energy is beyond

double hann(double share) noexcept { return (1 - dsp::cos(dsp::kTwoPi * share)) / 2; }

/// Power of a Hann pulse of unit width at `f` widths: (sinc(f) / (1 - f^2))^2.
double hann_power(double f) noexcept {
  if (std::fabs(f - 1) < 1e-6) return 0.25;
  const double sinc = f == 0 ? 1 : dsp::sin(dsp::kPi * f) / (dsp::kPi * f), h = sinc / (1 - f * f);
  return h * h;
}

/// Once from the struck end to the bit and back, s.
double round_trip_s(const StringModel& model) noexcept {
  return 2 * (model.shank_length_m + model.rod_length_m) / kSpeedOfSound;
}

}  // namespace

double joint_transmission(const StringModel& model) {
  // A slab of m times the impedance: 1 / T = 1 + ((m - 1/m) / 2)^2 sin^2(w l / c).
  const double m = model.sleeve_impedance, mismatch = (m - 1 / m) / 2;
  const double turn = dsp::kTwoPi * model.sleeve_length_m / (kSpeedOfSound * model.strike_width_s);
  double sent = 0, through = 0;
  for (int i = 0; i < kSpectrumPoints; ++i) {
    const double f = kSpectrumWidths * (i + 0.5) / kSpectrumPoints, power = hann_power(f);
    const double s = mismatch * dsp::sin(turn * f);
    sent += power, through += power / (1 + s * s);
  }
  return through / sent;
}

double energy_passes(const StringModel& model, double stiffness_n_per_m) {
  std::vector<double> pulse;
  for (int n = 0; n < kPulseSamples; ++n) pulse.push_back(hann((n + 0.5) / kPulseSamples));
  const double loading = loading_time_s(model, stiffness_n_per_m) * kPulseSamples / model.strike_width_s;
  const double kept = dsp::exp(-6 * dsp::kLn10 * round_trip_s(model) / model.guided_s);
  return 1 / (1 - kept * played_reflection(pulse, loading).energy);
}

}  // namespace rigsound
