// What one simulated impact sounds like: an enveloped burst of noise or a ringing of 48 modes, coloured.
#pragma once

#include <cstdint>
#include <vector>

#include "rigsound/analysis/click_train.hpp"
#include "simulate/biquad_cascade.hpp"
#include "simulate/click_process.hpp"
#include "simulate/split_mix.hpp"

namespace rigsound::analysis {

/// A partial of the ringing steel.
struct Mode {
  double frequency;  ///< Hz
  double amplitude;
  double phase;  ///< rad
};

struct ClickVoice {
  ClickEnvelope envelope;
  BiquadCascade colour;
  std::vector<Mode> modes;  ///< empty: noise-like
  double ring = 1;          ///< decay rate of the modes relative to alpha_d
  std::uint64_t noise_seed = 0,
                variation_seed = 0;  ///< streams of the grains and of what changes between them

  /// Samples until a click has decayed by 70 dB.
  int length() const;
};

/// Four broad bells, different for every click, that leave the energy of white noise as it is.
BiquadCascade draw_variation(SplitMix& stream);

/// White noise through `bells`, from their settled state on.
std::vector<double> coloured_noise(const BiquadCascade& bells, int length, SplitMix& noise);

/// highpass, lowpass and five resonances.
BiquadCascade draw_colour(SplitMix& stream);

/// 48 modes between 150 Hz and 14 kHz, ascending. Always the same number of draws.
std::vector<Mode> draw_modes(SplitMix& stream);

/// The envelope of eq. 5 and 6 of the drilling paper, `length` samples.
std::vector<double> envelope_curve(const ClickEnvelope& shape, int length);

/// Sum of all clicks, coloured, `frames` samples. Click i starts at `onsets[i]`; its waveform depends only on
/// i, so the same clicks can be played at another rate.
std::vector<double> render_clicks(const ClickVoice& voice, const std::vector<SimulatedClick>& clicks,
                                  const std::vector<int>& onsets, int frames);

}  // namespace rigsound::analysis
