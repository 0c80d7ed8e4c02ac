#include "simulate/drilling_click.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "simulate/click_voice.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kAttackSamples = 40, kAttackBend = 1.5;  // alpha_a N_a
constexpr double kRod_m = 3.66, kSpeed_m_s = 5200, kHighestModeHz = 14000;
constexpr std::size_t kMostModes = 24;
constexpr double kModeScatterDb = 3;
constexpr int kRingOut = 1024;  // samples the colour goes on behind the envelope

/// At most kMostModes of the string's modes, evenly chosen.
std::vector<double> string_modes_hz(int rods) {
  const double lowest = kSpeed_m_s / (2 * kRod_m * rods);
  const auto count = static_cast<std::size_t>(kHighestModeHz / lowest), kept = std::min(count, kMostModes);
  std::vector<double> modes;
  for (std::size_t i = 1; i <= kept; ++i) {
    const std::size_t number = i * count / kept;
    modes.push_back(lowest * static_cast<double>(number));
  }
  return modes;
}

void to_unit_norm(std::vector<double>& x) {
  double energy = 0;
  for (const double v : x) energy += v * v;
  for (double& v : x) v /= std::sqrt(energy);
}

}  // namespace

ClickEnvelope drilling_envelope(const DrillingPoint& point) {
  return {kAttackSamples, kAttackBend / kAttackSamples, point.decay};
}

double brightness_hz(const DrillingPoint& point, int rods) {
  std::vector<double> h(4096, 0.0);
  h[0] = 1;
  filter(drilling_colour(point), h);
  // Power of the click, and of its first differences.
  double power = 0, steps = 0, before = 0;
  for (const double v : h) {
    power += (1 - point.ring_share) * v * v, steps += (1 - point.ring_share) * (v - before) * (v - before);
    before = v;
  }
  const std::vector<double> modes = string_modes_hz(rods);
  for (const double f : modes) {
    std::complex<double> response;
    const double w = dsp::kTwoPi * f / kAnalysisRate;
    for (std::size_t n = 0; n < h.size(); ++n)
      response += h[n] * std::polar(1.0, -w * static_cast<double>(n));
    const double mode = point.ring_share * std::norm(response) / static_cast<double>(modes.size());
    power += mode, steps += mode * std::pow(2 * std::sin(w / 2), 2);
  }
  return std::asin(std::sqrt(steps / power) / 2) * 2 * kAnalysisRate / dsp::kTwoPi;
}

DrillingClicks::DrillingClicks(int rods, std::uint64_t noise_seed, std::uint64_t variation_seed)
    : modes_hz_(string_modes_hz(rods)), noise_(noise_seed), variation_(variation_seed) {}

/// Of mean square one. Phases differ from click to click: the impact meets the string in any state.
std::vector<double> DrillingClicks::draw_ringing(int length) {
  std::vector<double> sum(static_cast<std::size_t>(length), 0.0);
  double power = 0;
  for (const double f : modes_hz_) {
    const double amplitude = std::pow(10, kModeScatterDb * variation_.normal() / 20);
    std::complex<double> phasor = std::polar(amplitude, dsp::kTwoPi * variation_.uniform());
    const std::complex<double> turn = std::polar(1.0, dsp::kTwoPi * f / kAnalysisRate);
    for (double& v : sum) v += phasor.imag(), phasor *= turn;
    power += amplitude * amplitude / 2;
  }
  for (double& v : sum) v /= std::sqrt(power);
  return sum;
}

std::vector<double> DrillingClicks::draw(const DrillingPoint& point) {
  ClickVoice voice;
  voice.envelope = drilling_envelope(point);
  const int length = voice.length();
  const std::vector<double> ringing = draw_ringing(length), a = envelope_curve(voice.envelope, length);
  std::vector<double> click = coloured_noise(draw_variation(variation_), length, noise_);
  const double noise_gain = std::sqrt(1 - point.ring_share), ring_gain = std::sqrt(point.ring_share);
  for (int n = 0; n < length; ++n) click[n] = a[n] * (noise_gain * click[n] + ring_gain * ringing[n]);
  click.resize(click.size() + kRingOut, 0.0);
  filter(drilling_colour(point), click);
  to_unit_norm(click);
  return click;
}

}  // namespace rigsound::analysis
