#include "string/design/string_tuning.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/steel.hpp"

namespace rigsound::string {
namespace {

constexpr double kLowLoss_hz = 500, kHighLoss_hz = 5000;  // where the decay times of the model hold
constexpr double kFraction_hz = 4500;                     // and fractions of a sample
// Fractions cost the more the more rods there are, and matter the less the longer these are.
constexpr int kFewRods = 6;
constexpr double kShortRod_m = 2.5;

/// A sleeve on the grid, and how much longer or shorter that leaves the rods around it, round trip samples.
/// With impedance z and round trip t, z t is its mass and t / z its compliance: both are kept.
void fit_sleeve(const StringModel& model, double sample_rate, StringTuning& tuning, double& rods_gain) {
  const double wanted = round_trip_samples(model.sleeve_length_m, sample_rate), Z = model.sleeve_impedance;
  tuning.sleeve_steps = wanted < 1.5 * kSleeveStep ? 1 : wanted < 3 * kSleeveStep ? 2 : 4;
  const double held = tuning.sleeve_steps * kSleeveStep, q = (Z - 1 / Z) * wanted / held;
  tuning.sleeve_impedance = (q + std::sqrt(q * q + 4)) / 2;
  rods_gain = Z * wanted - tuning.sleeve_impedance * held;
}

/// A chunk, two sleeves or one, as much as no line's round trip is shorter than.
int block_within(const StringTuning& tuning) {
  int shortest = tuning.joints == 0 ? tuning.delay[0] : tuning.delay[1];
  for (int j = 2; j <= tuning.joints; ++j) shortest = std::min(shortest, tuning.delay[j]);
  const int step = kSleeveStep * tuning.sleeve_steps;
  return kChunk <= shortest ? kChunk : 2 * step <= shortest ? 2 * step : step;
}

/// A shank too short for the grid borrows from the rods below it.
void place_head(double head, StringTuning& tuning) {
  const int least = kSleeveStep * tuning.sleeve_steps;
  for (int j = 1; j <= tuning.joints; ++j)
    while (head < least + 2.5 && tuning.delay[j] > least) ++head, --tuning.delay[j];
  head = std::max(head, least + 2.5);
  tuning.delay[0] = static_cast<int>(std::floor(head - 2.5));
  tuning.head_delay = head - 1 - tuning.delay[0];
}

/// Fraction that makes the interpolator's delay 1 + `wanted` where it matters most, not at 0 Hz.
double fraction_for(double wanted, double sample_rate) {
  const double omega = dsp::kTwoPi * kFraction_hz / sample_rate, t = dsp::tan(wanted * omega);
  const double s = dsp::sin(omega), rest = 1 - dsp::cos(omega);
  return 2 * t / (s + std::sqrt(s * s + 4 * t * t * rest));
}

/// Every rod's own length.
void place_fractions(const double* wanted, double sample_rate, StringTuning& tuning) {
  for (int j = 1; j <= tuning.joints; ++j) {
    const double whole = std::floor(wanted[j] + 0.5);
    tuning.delay[j] = std::max(kSleeveStep * tuning.sleeve_steps, static_cast<int>(whole) - 1);
    tuning.fraction[j] = fraction_for(wanted[j] - whole, sample_rate);
  }
  tuning.has_fractions = true;
  place_head(wanted[0], tuning);
}

/// From the bit up, so that the fraction of a sample is left to the shank.
void place_lines(const double* wanted, StringTuning& tuning) {
  const int least = kSleeveStep * tuning.sleeve_steps;
  double carried = 0;
  for (int j = tuning.joints; j > 0; --j) {
    const double here = wanted[j] + carried;
    tuning.delay[j] = std::max(least, static_cast<int>(std::floor(here + 0.5)));
    carried = here - tuning.delay[j];
  }
  place_head(wanted[0] + carried, tuning);
}

/// Gains of the reflection at both reference frequencies give a zero-phase filter of three taps; its gain may
/// neither turn negative nor exceed 1.
void place_losses(const StringModel& model, double sample_rate, StringTuning& tuning) {
  const auto gain = [&](double t60_s) {
    return dsp::exp(-3 * dsp::kLn10 * tuning.round_trip() / (t60_s * sample_rate));
  };
  const double cos_low = dsp::cos(dsp::kTwoPi * kLowLoss_hz / sample_rate);
  const double cos_high = dsp::cos(dsp::kTwoPi * kHighLoss_hz / sample_rate);
  const double low = gain(model.string_low_s), high = gain(model.string_high_s);
  const double steepest = std::min(low / (1 + cos_low), (1 - low) / (1 - cos_low));
  const double swing = std::min(steepest, (low - high) / (cos_low - cos_high));
  tuning.loss_middle = low - swing * cos_low;
  tuning.loss_side = swing / 2;
}

}  // namespace

double round_trip_samples(double length_m, double sample_rate) noexcept {
  return 2 * length_m / kSpeedOfSound * sample_rate;
}

double rod_impedance(const StringModel& model) noexcept {
  return dsp::kPi / 4 * model.rod_diameter_m * model.rod_diameter_m * kDensity * kSpeedOfSound;
}

double StringTuning::round_trip() const noexcept {
  double sum = 1 + head_delay + joints * sleeve_steps * kSleeveStep;
  for (int j = 0; j <= joints; ++j) sum += delay[j] + (has_fractions && j > 0 ? 1 + fraction[j] : 0);
  return sum;
}

Thiran thiran(double delay) noexcept {
  return {-2 * (delay - 2) / (delay + 1), (delay - 2) * (delay - 1) / ((delay + 1) * (delay + 2))};
}

Lagrange lagrange(double d) noexcept { return {{d * (d - 1) / 2, 1 - d * d, d * (d + 1) / 2}}; }

StringTuning tune_string(const StringModel& model, int rods, double sample_rate) {
  StringTuning tuning;
  tuning.joints = model.shank_length_m > 0 ? rods : rods - 1;
  double rods_gain = 0;
  fit_sleeve(model, sample_rate, tuning, rods_gain);
  const double sleeve = round_trip_samples(model.sleeve_length_m, sample_rate);
  double wanted[kMaxLines] = {};
  for (int j = 0; j <= tuning.joints; ++j) {
    const bool is_shank = j == 0 && model.shank_length_m > 0;
    const double beside = (j > 0 ? 0.5 : 0) + (j < tuning.joints ? 0.5 : 0);  // sleeves that cover it
    wanted[j] = round_trip_samples(is_shank ? model.shank_length_m : model.rod_length_m, sample_rate) +
                beside * (rods_gain - sleeve);
  }
  // Without sleeves it does not matter where a rod ends.
  if (model.sleeve_impedance > 1 && (rods <= kFewRods || model.rod_length_m < kShortRod_m))
    place_fractions(wanted, sample_rate, tuning);
  else
    place_lines(wanted, tuning);
  tuning.block = block_within(tuning);
  place_losses(model, sample_rate, tuning);
  return tuning;
}

}  // namespace rigsound::string
