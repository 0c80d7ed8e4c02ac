#include "simulate/click_voice.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "clicks/envelope.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/elementary.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kSettle = 256;  // samples a filter runs in before its output is used
constexpr std::size_t kModes = 48;

std::vector<double> attack_only(const ClickEnvelope& envelope, int length) {
  return envelope_curve({envelope.attack_samples, envelope.attack_bend, 0}, length);
}

/// Adds one decaying sine by rotating a phasor: exact to rounding, without a sine per sample.
void add_mode(std::vector<double>& sum, const Mode& mode, double decay, double N_a) {
  const double w = dsp::kTwoPi * mode.frequency / kAnalysisRate;
  std::complex<double> phasor = std::polar(mode.amplitude, mode.phase);
  const std::complex<double> turn = std::polar(1.0, w);
  const double fade = std::exp(-decay);
  for (std::size_t n = 0; n < sum.size(); ++n) {
    sum[n] += phasor.imag();
    phasor *= static_cast<double>(n) >= N_a ? turn * fade : turn;
  }
}

std::vector<double> modal_click(const ClickVoice& voice, const std::vector<double>& attack,
                                const BiquadCascade& bells, SplitMix& variation, SplitMix& noise) {
  const auto length = static_cast<int>(attack.size());
  std::vector<Mode> modes = voice.modes;
  for (Mode& m : modes) m.amplitude *= std::pow(10, variation.normal() * 3 / 20);
  for (Mode& m : modes) m.phase += 0.5 * variation.normal();
  std::vector<double> s(attack.size(), 0.0);
  double power = 0;
  for (std::size_t j = 0; j < modes.size(); ++j) {
    const double rate = std::pow(voice.modes[j].frequency / 1500, 0.25);
    modes[j].frequency *= 1 + 0.001 * variation.normal();
    power += voice.modes[j].amplitude * voice.modes[j].amplitude;
    add_mode(s, modes[j], voice.ring * voice.envelope.decay * rate, voice.envelope.attack_samples);
  }
  const std::vector<double> burst = coloured_noise(bells, length, noise);
  const double scale = 1 / std::sqrt(power / 2), burst_decay = 1 / (0.002 * kAnalysisRate);
  for (std::size_t n = 0; n < s.size(); ++n)
    s[n] = attack[n] * (s[n] * scale + 0.7 * burst[n] * std::exp(-static_cast<double>(n) * burst_decay));
  return s;
}

}  // namespace

int ClickVoice::length() const {
  // With whole decibels a period the length is often a whole number: the margin keeps rounding out of it.
  return static_cast<int>(envelope.attack_samples + std::log(10.0) * (70.0 / 20) / envelope.decay + 1e-6);
}

BiquadCascade draw_variation(SplitMix& stream) {
  constexpr double kCentres[] = {500, 1500, 4500, 12000};
  BiquadCascade bells;
  for (const double centre : kCentres) bells.push_back(peaking(centre, 3.0 * stream.normal(), 0.7));
  std::vector<double> impulse(2048, 0.0);
  impulse[0] = 1;
  filter(bells, impulse);
  double energy = 0;
  for (const double h : impulse) energy += h * h;
  const double scale = 1 / std::sqrt(energy);
  bells[0].b0 *= scale, bells[0].b1 *= scale, bells[0].b2 *= scale;
  return bells;
}

std::vector<double> coloured_noise(const BiquadCascade& bells, int length, SplitMix& noise) {
  std::vector<double> u = noise.normals(static_cast<std::size_t>(length + kSettle));
  filter(bells, u);
  u.erase(u.begin(), u.begin() + kSettle);
  return u;
}

BiquadCascade draw_colour(SplitMix& stream) {
  BiquadCascade colour;
  colour.push_back(highpass(stream.log_uniform(60, 150)));
  colour.push_back(one_pole(stream.log_uniform(2500, 9000)));
  for (int i = 0; i < 5; ++i) {
    const double f = stream.log_uniform(200, 9000), gain_db = stream.uniform(4, 14),
                 q = stream.log_uniform(0.8, 6);
    colour.push_back(peaking(f, gain_db, q));
  }
  return colour;
}

std::vector<Mode> draw_modes(SplitMix& stream) {
  std::vector<double> f = stream.uniforms(kModes);
  for (double& v : f) v = 150 * std::pow(14000.0 / 150, v);
  std::sort(f.begin(), f.end());
  std::vector<Mode> modes(kModes);
  for (std::size_t j = 0; j < kModes; ++j) modes[j].frequency = f[j];
  for (Mode& m : modes) m.amplitude = std::pow(10, stream.normal() * 5 / 20);
  for (Mode& m : modes) m.phase = dsp::kTwoPi * stream.uniform();
  return modes;
}

std::vector<double> envelope_curve(const ClickEnvelope& shape, int length) {
  std::vector<double> a(static_cast<std::size_t>(length));
  for (int n = 0; n < length; ++n) a[n] = envelope(shape, n);
  return a;
}

std::vector<double> render_clicks(const ClickVoice& voice, const std::vector<SimulatedClick>& clicks,
                                  const std::vector<int>& onsets, int frames) {
  const int length = voice.length();
  SplitMix noise(voice.noise_seed), variation(voice.variation_seed);
  const std::vector<double> a = envelope_curve(voice.envelope, length),
                            attack = attack_only(voice.envelope, length);
  std::vector<double> y(static_cast<std::size_t>(frames) + length + 8, 0.0);
  for (std::size_t i = 0; i < clicks.size(); ++i) {
    const BiquadCascade bells = draw_variation(variation);
    std::vector<double> grain;
    if (voice.modes.empty()) {
      grain = coloured_noise(bells, length, noise);
      for (int n = 0; n < length; ++n) grain[n] *= a[n];
    } else {
      grain = modal_click(voice, attack, bells, variation, noise);
    }
    if (onsets[i] >= frames) continue;
    for (int n = 0; n < length; ++n) y[onsets[i] + n] += clicks[i].beta * grain[n];
  }
  filter(voice.colour, y);
  y.resize(static_cast<std::size_t>(frames));
  return y;
}

}  // namespace rigsound::analysis
