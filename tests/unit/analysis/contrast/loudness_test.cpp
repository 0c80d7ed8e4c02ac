// Loudness against the values that ISO 532-1 publishes (annexes B.2 and B.3) and that its program gives.
#include "contrast/loudness.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "analysis/noise.hpp"
#include "rigsound/analysis/rate.hpp"

using namespace rigsound::analysis;

namespace {

constexpr double kFullScale_db = 100;

std::vector<float> tone(double hz, double db_spl, double seconds = 5) {
  const double amplitude = std::pow(10, (db_spl - kFullScale_db) / 20);
  std::vector<float> x;
  for (int n = 0; n < seconds * kAnalysisRate; ++n)
    x.push_back(static_cast<float>(amplitude * std::sin(2 * kPi * hz * n / kAnalysisRate)));
  return x;
}

double sone(const std::vector<float>& x) { return loudness_sone(loudness_bands(x, kFullScale_db)); }

/// Octave levels from 63 Hz on, each shared by its three thirds; nothing below 50 Hz and above 10 kHz.
LoudnessBands from_octaves(const std::array<double, 8>& octaves, double gain_db) {
  LoudnessBands levels;
  levels.fill(-60);
  for (std::size_t i = 0; i < 24; ++i) levels[3 + i] = octaves[i / 3] + gain_db - 10 * std::log10(3);
  return levels;
}

}  // namespace

TEST_CASE("annex B.2: third-octave levels of test signal 1 have 83.296 sone") {
  const LoudnessBands levels{-60, -60, 78, 79, 89, 72, 80, 89, 75, 87, 85, 79, 86, 80,
                             71,  70,  72, 71, 72, 74, 69, 65, 67, 77, 68, 58, 45, 30};
  CHECK(loudness_sone(levels) == doctest::Approx(83.296).epsilon(0.0005));
}

TEST_CASE("annex B.3: tones of the test signals 2 to 4, within the standard's 5 % or 0.1 sone") {
  CHECK(sone(tone(250, 80)) == doctest::Approx(14.655).epsilon(0.02));
  CHECK(sone(tone(1000, 60)) == doctest::Approx(4.019).epsilon(0.02));
  CHECK(sone(tone(4000, 40)) == doctest::Approx(1.549).epsilon(0.02));
}

TEST_CASE("a sone is a tone of 40 dB at 1 kHz; ten decibels more are twice as loud") {
  CHECK(sone(tone(1000, 40)) == doctest::Approx(1).epsilon(0.03));
  CHECK(sone(tone(1000, 70)) == doctest::Approx(8).epsilon(0.03));
  CHECK(loudness_level_phon(1) == doctest::Approx(40));
  CHECK(loudness_level_phon(8) == doctest::Approx(70));
  CHECK(loudness_level_phon(0) == doctest::Approx(3));
  CHECK(loudness_level_phon(0.9999) == doctest::Approx(40).epsilon(0.001));
}

TEST_CASE("levels that other programs after the standard were given, and what they made of them") {
  const LoudnessBands a{56.88, 77.29, 68.18, 26.89, 32.51, 75.52, 10.39, 71.59, 69.78, 45.10,
                        32.73, 30.88, 29.12, 43.38, 47.84, 51.51, 84.66, 69.45, 56.66, 84.17,
                        26.15, 22.02, 55.94, 13.30, 12.68, 48.62, 44.97, 78.79};
  const LoudnessBands b{57.19, 48.56, 47.27, 28.56, 10.88, 24.43, 61.90, 25.05, 37.72, 10.28,
                        72.25, 21.58, 30.07, 76.02, 48.23, 73.54, 57.98, 65.63, 16.86, 50.59,
                        48.08, 75.35, 37.09, 54.86, 14.44, 39.07, 34.23, 21.26};
  const LoudnessBands c{71.23, 38.46, 83.41, 54.25, 55.38, 57.85, 60.73, 21.31, 43.02, 27.97,
                        40.19, 17.25, 82.59, 26.13, 60.38, 32.53, 75.56, 59.67, 19.87, 73.38,
                        80.87, 77.79, 52.73, 20.91, 24.43, 79.59, 51.42, 23.54};
  const LoudnessBands d{76.30, 58.12, 52.73, 38.22, 40.82, 27.96, 12.85, 75.72, 45.08, 51.07,
                        34.16, 66.35, 11.89, 37.91, 12.28, 19.22, 82.54, 59.33, 42.12, 49.28,
                        75.46, 35.82, 54.27, 61.28, 36.66, 48.93, 67.39, 78.19};
  CHECK(loudness_sone(a) == doctest::Approx(53.64).epsilon(0.003));
  CHECK(loudness_sone(b) == doctest::Approx(42.0).epsilon(0.003));
  CHECK(loudness_sone(c) == doctest::Approx(67.0).epsilon(0.003));
  CHECK(loudness_sone(d) == doctest::Approx(46.27).epsilon(0.003));
  const std::array<double, 8> road{98.35, 91.1, 89.4, 90.7, 95.6, 92.4, 84.6, 76.2};
  CHECK(loudness_sone(from_octaves(road, -60)) == doctest::Approx(2.48).epsilon(0.003));
  CHECK(loudness_sone(from_octaves(road, -40)) == doctest::Approx(12.075).epsilon(0.003));
  CHECK(loudness_sone(from_octaves(road, -20)) == doctest::Approx(43.34).epsilon(0.003));
  CHECK(loudness_sone(from_octaves({75, 78, 76, 72, 66, 58, 45, 30}, -5)) ==
        doctest::Approx(21.39).epsilon(0.003));
}

TEST_CASE("bands hold the power of the sound, silence is silent") {
  const LoudnessBands levels = loudness_bands(tone(1000, 74), kFullScale_db);
  CHECK(levels[16] == doctest::Approx(74).epsilon(0.001));
  CHECK(levels[15] < 57);
  CHECK(levels[15] > 53);
  CHECK(levels[0] == -60);
  CHECK(loudness_sone(loudness_bands(std::vector<float>(48000), kFullScale_db)) == 0);
  // White noise: three decibels more an octave up.
  TestNoise noise(3);
  const LoudnessBands white = loudness_bands(samples(noise.normals(960000) * 0.01), kFullScale_db);
  CHECK(white[20] - white[17] == doctest::Approx(3).epsilon(0.1));
  CHECK(white[4] - white[1] == doctest::Approx(3).scale(0).epsilon(0.4));
}
