// What is measured of a sound to tell it from another.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bank/third_octave.hpp"
#include "rigsound/dsp/random.hpp"

namespace rigsound::analysis {

struct Heard {
  BandLevels third_octaves;  ///< dB re full scale, never below kFaintest_db
  BandLevels modulation;     ///< of the envelope, dB re its mean
  double rate_hz = 0;        ///< impacts a second
};

constexpr double kFaintest_db = -100;  ///< nobody hears less

/// Of half a second at least, at kAnalysisRate. Thread: OFF.
Heard listen(const std::vector<float>& x);

/// Means of the absolute differences of levels, and the difference of the rates over their mean. Thread: OFF.
struct Distance {
  double third_octave_db = 0, modulation_db = 0, rate = 0;
};
Distance distance(const Heard& a, const Heard& b);

/// Noise of the ear, standard deviations. 2 dB in each third octave make 0.4 dB of them all, which gives the
/// just noticeable differences of level that are measured: half a decibel of broadband noise, two or three in
/// one band among many. The depth of a modulation is noticed to change by 1 to 2 dB in an octave of
/// modulation frequency, a tempo by 2 to 3 %.
constexpr double kBandNoise_db = 2, kModulationNoise_db = 3.5, kRateNoise = 0.025;

/// What a listener takes from an excerpt of one second: the levels of third octaves and of modulation from 4
/// Hz on, and the logarithm of the rate, each with the ear's own noise. `index` counts excerpts. Thread: OFF.
Eigen::VectorXd noticed(const Heard& heard, const dsp::RandomField& ear, std::uint64_t index);

}  // namespace rigsound::analysis
