// A bank with known clicks: damped sines of one length each. And a set of nothing else.
#pragma once

#include <cmath>
#include <string>

#include "rigsound/click_bank.hpp"
#include "rigsound/config/sound_set_parts.hpp"

namespace rigsound::test {

inline std::vector<float> damped_sine(double frequency_hz, double decay_s, double rate, int length) {
  std::vector<float> x(static_cast<std::size_t>(length));
  double energy = 0;
  for (int i = 0; i < length; ++i) {
    const double t = i / rate, attack = 1 - std::exp(-t / 0.0015);
    const double v =
        attack * std::exp(-t / decay_s) * std::sin(2 * 3.14159265358979323846 * frequency_hz * t);
    x[static_cast<std::size_t>(i)] = static_cast<float>(v);
    energy += v * v;
  }
  for (float& v : x) v = static_cast<float>(v / std::sqrt(energy));
  return x;
}

inline ClickBank example_bank(const std::string& name, double rate = 48000, int clicks = 5) {
  ClickBank bank;
  bank.name = name;
  bank.sample_rate = rate;
  bank.mean_gap_samples = rate / 30.0;
  bank.gap_deviation_samples = bank.mean_gap_samples / 17.0;
  bank.gap_correlation = -0.31;
  bank.miss_share = 0.01;
  bank.double_share = 0.02;
  bank.mean_amplitude = 0.1 + 1.0 / 3.0;
  bank.amplitude_deviation = 0.07;
  bank.amplitude_correlation = 0.2;
  bank.attack_samples = 0.001 * rate;
  bank.attack_bend = 60 / rate;
  bank.decay = 200 / rate;
  bank.gain_db = -2.5;
  for (int i = 0; i < clicks; ++i)
    bank.clicks.push_back(damped_sine(900 + 200 * i, 0.005, rate, static_cast<int>(0.03 * rate) + i));
  return bank;
}

/// An index in which one bank sounds in every situation.
inline config::SoundSetIndex five_situations(const std::string& bank) {
  config::SoundSetIndex index;
  for (int s = 0; s < kSituationCount; ++s) {
    config::BankEntry& entry = index.banks.emplace_back();
    entry.name = bank, entry.situation = static_cast<Situation>(s);
  }
  return index;
}

inline config::SoundSetParts one_bank_set(const std::string& name) {
  config::SoundSetParts parts;
  parts.index = five_situations(name);
  parts.banks.push_back({example_bank(name), {}});
  return parts;
}

}  // namespace rigsound::test
