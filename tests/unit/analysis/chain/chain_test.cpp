// The whole chain against recordings whose truth is known.
#include "rigsound/analysis/chain.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "analysis/f_measure.hpp"
#include "analysis/noise.hpp"
#include "rigsound/analysis/recording.hpp"
#include "simulate/drillbench_clip.hpp"
#include "simulate/drilling_recording.hpp"
#include "spectrum/stft.hpp"
#include "temporary_folder.hpp"

using namespace rigsound::analysis;

namespace {

struct Case {
  DrillBenchClip truth;
  std::vector<float> mix, clean;
};

Case clip(int id, double snr_db, double seconds) {
  Case c{drillbench_clip(id, seconds), {}, {}};
  const std::vector<double> background = drillbench_background(id, seconds);
  const double gain = std::pow(10, -snr_db / 20);
  for (size_t n = 0; n < background.size(); ++n) {
    c.clean.push_back(float(0.05 * c.truth.clean[n]));
    c.mix.push_back(float(0.05 * (c.truth.clean[n] + gain * background[n])));
  }
  return c;
}

/// F measure at 2 ms against the true strikes (bounces are not clicks).
double f_of_strikes(const Case& c, const ClickTrain& found) {
  std::vector<long> truth;
  for (const SimulatedClick& click : c.truth.clicks)
    if (click.kind != ClickKind::kBounce && click.P < long(c.mix.size())) truth.push_back(click.P);
  return f_measure(found.P, truth);
}

struct LowDrill {
  std::vector<long> P;
  std::vector<float> sound;  ///< RMS 0.05
};

struct Band {
  double from_hz, to_hz;
};

/// Forty modes of the band struck at 4 % jitter, which fall by 15 dB or so until the next impact.
LowDrill low_drill(double rate_hz, double seconds, unsigned seed, const Band& band = {150, 900}) {
  TestNoise noise(seed);
  const double T = 48000 / rate_hz;
  const long length = long(seconds * 48000);
  std::vector<double> hz(40), level(40), phase(40);
  for (int k = 0; k < 40; ++k) {
    hz[k] = band.from_hz * std::pow(band.to_hz / band.from_hz, noise.uniform());
    level[k] = std::exp(0.6 * noise.normal());
    phase[k] = 2 * kPi * noise.uniform();
  }
  LowDrill s{{}, std::vector<float>(length)};
  for (double t = 0.4 * T; t + 1 < double(length); t += T * (1 + 0.04 * noise.normal())) {
    const long P = long(t), end = std::min(length, P + long(3 * T));
    s.P.push_back(P);
    const double strength = std::max(0.25, 1 + 0.2 * noise.normal());
    for (int k = 0; k < 40; ++k) {
      const double turn = 2 * kPi * hz[k] / 48000, fall = 2.5 * std::pow(hz[k] / 1500, 0.25) / T;
      const double gain = strength * level[k] * std::exp(0.23 * noise.normal()),
                   start = phase[k] + 0.4 * noise.normal();
      std::complex<double> mode = std::polar(gain, start), step = std::polar(std::exp(-fall), turn);
      for (long n = P; n < end; ++n, mode *= step)
        s.sound[n] += float(mode.imag() * std::min(1.0, double(n - P) / 20));
    }
  }
  double square = 0;
  for (const float y : s.sound) square += double(y) * y;
  for (float& y : s.sound) y *= float(0.05 / std::sqrt(square / double(length)));
  return s;
}

/// `low`, of `seconds`, is found as loud as a background of the bench; its onsets to the period of the lowest
/// mode.
void check_found_in_background(LowDrill low, int id, double seconds, double least_f) {
  const std::vector<double> background = drillbench_background(id, seconds);
  for (size_t n = 0; n < low.sound.size(); ++n) low.sound[n] += float(0.05 * background[n]);
  const ChainResult result = run_chain(low.sound, {});
  CAPTURE(id);
  CHECK(result.drilling_found);
  CHECK(f_measure(result.clicks.P, low.P, 240) > least_f);
}

double si_sdr(const std::vector<float>& s, const std::vector<float>& e) {
  double es = 0, ss = 0, rest = 0;
  for (size_t n = 0; n < s.size(); ++n) es += double(e[n]) * s[n], ss += double(s[n]) * s[n];
  for (size_t n = 0; n < s.size(); ++n) rest += std::pow(e[n] - es / ss * s[n], 2);
  return 10 * std::log10(es * es / ss / rest);
}

std::vector<float> sound(double seconds, double (*at)(double t, TestNoise&), unsigned seed) {
  TestNoise noise(seed);
  std::vector<float> x;
  for (int n = 0; n < int(seconds * 48000); ++n) x.push_back(float(0.1 * at(n / 48000.0, noise)));
  return x;
}

double white(double, TestNoise& noise) { return noise.normal(); }

double rotary_drill(double t, TestNoise& noise) {
  const double turn = 2 * kPi * 28 * t;
  double whine = 0;
  for (const int k : {1, 2, 7, 14, 23, 44}) whine += std::sin(k * turn + k) / std::sqrt(k);
  return whine + (1 + 0.6 * std::sin(turn)) * noise.normal();
}

/// A voice: pulses of 110 to 150 Hz through two formants, syllables of a quarter of a second.
double voice(double t, TestNoise& noise) {
  const double pitch = 130 * t - 20 / (2 * kPi * 3) * std::cos(2 * kPi * 3 * t),
               since = pitch - std::floor(pitch);
  const double syllable = std::pow(std::max(0.0, std::sin(2 * kPi * 2 * t)), 0.5);
  const double age = since / 130;
  return syllable * (std::exp(-400 * age) * std::sin(2 * kPi * 650 * age) +
                     0.6 * std::exp(-600 * age) * std::sin(2 * kPi * 1700 * age)) +
         0.003 * noise.normal();
}

double music(double t, TestNoise& noise) {
  const double beat = t - 0.25 * std::floor(t / 0.25), hz[] = {220, 277.18, 329.63, 440, 246.94};
  double sum = 0;
  for (int k = 1; k < 10; ++k)
    sum += std::sin(2 * kPi * hz[int(t / 0.25) % 5] * k * t) / k * std::exp(-4 * beat * k);
  return sum + 0.001 * noise.normal();
}

/// A drum machine: accented hats at every sixteenth of 170 beats a minute (11.3 a second), the seventh of
/// eight open, bass and snare drum in turn.
double drum_machine(double t, TestNoise& noise) {
  const double sixteenth = 60 / 170.0 / 4, beat = 4 * sixteenth;
  const double accents[] = {0.35, 0.2, 0.28, 0.2};
  const int step = int(t / sixteenth);
  const double hat = std::fmod(t, sixteenth), drum = std::fmod(t, beat), hiss = noise.normal();
  const bool snare = std::fmod(t, 2 * beat) >= beat;
  const double struck =
      snare ? (0.6 * hiss + std::sin(2 * kPi * 190 * drum)) * std::exp(-22 * drum)
            : std::sin(2 * kPi * (90 * drum - 0.7 * std::exp(-40 * drum))) * std::exp(-12 * drum);
  return struck + accents[step % 4] * hiss * std::exp((step % 8 == 6 ? -15 : -70) * hat);
}

}  // namespace

TEST_CASE("clicks and sound of clips with known truth" * doctest::test_suite("long")) {
  for (const int id : {100, 105, 109, 117}) {
    for (const double snr_db : {6.0, 0.0}) {
      CAPTURE(id);
      CAPTURE(snr_db);
      const Case c = clip(id, snr_db, 2);
      const ChainResult result = run_chain(c.mix, {});
      CHECK(result.drilling_found);
      CHECK(f_of_strikes(c, result.clicks) > 0.95);
      CHECK(result.drilling.size() == c.mix.size());
      CHECK(si_sdr(c.clean, result.drilling.all()) > snr_db + 3);
      CHECK(result.clicks.mean_gap_samples == doctest::Approx(c.truth.T0).epsilon(0.02));
      CHECK(result.signal_psd.size() == 257);
    }
  }
}

TEST_CASE("a low drill that rings slowly is found as loud as its background") {
  for (const unsigned seed : {1U, 5U})
    check_found_in_background(low_drill(14 + (seed * 7) % 27, 2, seed), 100 + int(seed), 2, 0.95);
}

TEST_CASE("low drills are found although a blind split takes the hiss above them for drilling") {
  for (const unsigned seed : {2U, 5U})
    check_found_in_background(low_drill(20 + 1.5 * seed, 4, seed), 100 + int(seed), 4, 0.95);
}

TEST_CASE("a drill of which one octave rises out of its background is found there") {
  for (const unsigned seed : {1U, 3U, 5U})
    check_found_in_background(low_drill(12 + 2 * seed, 2, seed, {280, 480}), 100 + int(seed), 2, 0.9);
}

TEST_CASE("a breaker that strikes twice in every period is heard twice, at its own period") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    TestNoise noise(seed);
    const long length = 4 * 48000;
    std::vector<long> P;
    for (double t = 2000; t + 3000 < double(length); t += 5854 * (1 + 0.04 * noise.normal()))
      P.push_back(long(t)), P.push_back(long(t) + 1248);
    std::vector<float> x(length);
    for (const long onset : P) {
      const double strength = 0.2 * std::max(0.25, 1 + 0.2 * noise.normal());
      for (long n = 0; n < 5000 && onset + n < length; ++n)
        x[onset + n] += float(strength * std::exp(-0.0018 * double(n)) * noise.normal());
    }
    for (float& sample : x) sample += float(0.02 * noise.normal());
    const ChainResult result = run_chain(x, {});
    CAPTURE(seed);
    CHECK(result.drilling_found);
    CHECK(result.machines.size() == 1);
    CHECK(f_measure(result.clicks.P, P) > 0.97);
    CHECK(result.clicks.mean_gap_samples == doctest::Approx(5854).epsilon(0.03));
  }
}

TEST_CASE("amplitudes are in the units of the recording") {
  const Case c = clip(109, 12, 2);
  ClickTrain quiet = run_chain(c.mix, {}).clicks;
  std::vector<float> louder(c.mix);
  for (float& x : louder) x *= 4;
  const ClickTrain loud = run_chain(louder, {}).clicks;
  REQUIRE(quiet.P.size() == loud.P.size());
  for (size_t i = 0; i < quiet.P.size(); ++i)
    CHECK(loud.beta[i] == doctest::Approx(4 * quiet.beta[i]).epsilon(1e-3));
}

TEST_CASE("a clean recording may skip the denoising and keeps its samples") {
  const Case c = clip(109, 0, 2);
  ChainOptions options;
  options.denoise = false;
  const ChainResult result = run_chain(c.clean, options);
  CHECK(f_of_strikes(c, result.clicks) > 0.95);
  CHECK(si_sdr(c.clean, result.drilling.all()) > 60);
}

TEST_CASE("a long recording is one train, the same for any number of jobs and on every run" *
          doctest::test_suite("long")) {
  const Case c = clip(105, 6, 9);
  ChainOptions options;
  const ChainResult one = run_chain(c.mix, options);
  CHECK(f_of_strikes(c, one.clicks) > 0.97);
  options.jobs = 3;
  int reports = 0;
  options.progress = [&](int done, int total) { reports = done == total ? 100 + total : done; };
  const ChainResult three = run_chain(c.mix, options);
  CHECK(one.clicks.P == three.clicks.P);
  CHECK(one.clicks.beta == three.clicks.beta);
  CHECK(one.drilling.all() == three.drilling.all());
  CHECK(reports == 103);
}

TEST_CASE("a dump holds what every step made, the last one's drilling being the result") {
  const Case c = clip(109, 6, 2);
  const rigsound::test::TemporaryFolder folder;
  ChainOptions options;
  options.dump = folder.path;
  const ChainResult result = run_chain(c.mix, options);
  for (const char* name :
       {"blind_drilling.wav", "blind_powers.csv", "pass1_whitened.wav", "pass1_statistic.csv",
        "pass1_clicks.csv", "pass1_envelope.csv", "pass1_drilling.wav", "pass1_powers.csv",
        "pass2_whitened.wav", "pass2_statistic.csv", "pass2_clicks.csv", "pass2_envelope.csv",
        "pass2_powers.csv", "pass2_evidence.csv"})
    CHECK_MESSAGE(std::filesystem::exists(folder.path / name), name);
  CHECK(si_sdr(result.drilling.all(), read_recording(folder.path / "pass2_drilling.wav").mono) > 100);
  CHECK(si_sdr(result.drilling.all(), read_recording(folder.path / "blind_drilling.wav").mono) < 30);
}

TEST_CASE(
    "a stretch cut out of drilling decays as the drilling does, though it begins with other clicks' tails") {
  const DrillingLaws laws(6);
  for (const double feed_bar : {40.0, 65.0, 150.0}) {
    DrillingCourse course;
    course.seconds = 8;
    course.start_feed_bar = course.end_feed_bar = feed_bar;
    const DrillingRecording r = simulate_drilling(course, laws, {6, 0});
    const int first = 3 * 48000, last = first + 3 * 48000;
    ChainOptions clean;
    clean.denoise = false;
    const ClickTrain found =
        run_chain(std::vector<float>(r.clean.begin() + first, r.clean.begin() + last), clean).clicks;
    const auto inside = std::count_if(r.clicks.begin(), r.clicks.end(),
                                      [&](const SimulatedClick& c) { return c.P >= first && c.P < last; });
    INFO(feed_bar, " bar");
    CHECK(found.envelope.decay == doctest::Approx(laws.at(feed_bar, 1).decay).scale(0).epsilon(0.05));
    CHECK(std::abs(static_cast<long>(found.P.size()) - inside) <= 1);
  }
}

TEST_CASE("the modelled powers are shares of what was recorded, and the drilling's is its true one") {
  const DrillingLaws laws(6);
  DrillingCourse course;
  course.seconds = 8, course.snr_db = 6;
  course.start_feed_bar = course.end_feed_bar = 150;
  const DrillingRecording r = simulate_drilling(course, laws, {6, 0});
  std::vector<float> mix, clean;
  for (int n = 2 * 48000; n < 5 * 48000; ++n) {
    mix.push_back(static_cast<float>(r.clean[n] + r.background[n]));
    clean.push_back(static_cast<float>(r.clean[n]));
  }
  const ChainResult result = run_chain(mix, {});
  const auto power = [](const std::vector<float>& x) {
    return stft(x, kChainStft).abs2().cast<double>().rowwise().mean().eval();
  };
  const Eigen::ArrayXd recorded = power(mix), drilled = power(clean);
  double worst_db = 0;
  for (int k = 5; k < 200; ++k) {
    CHECK(result.signal_psd[k] + result.noise_psd[k] == doctest::Approx(recorded(k)).epsilon(0.01));
    worst_db = std::max(worst_db, std::fabs(10 * std::log10(result.signal_psd[k] / drilled(k))));
  }
  CHECK(worst_db < 1);
}

TEST_CASE("noise, a rotary drill, a voice, music and a drum machine are no drilling" *
          doctest::test_suite("long")) {
  for (const auto at : {white, rotary_drill, voice, music, drum_machine}) {
    const ChainResult result = run_chain(sound(3, at, 81), {});
    CHECK(!result.drilling_found);
    CHECK(result.clicks.P.empty());
    CHECK(!result.reason.empty());
    CHECK(result.drilling.size() == 3 * 48000);
  }
  for (const int id : {100, 107, 113, 120}) {
    const std::vector<double> background = drillbench_background(id, 2);
    CHECK(!run_chain(std::vector<float>(background.begin(), background.end()), {}).drilling_found);
  }
}

TEST_CASE("the paper's method finds the clicks too, if less exactly, and tells noise from drilling" *
          doctest::test_suite("long")) {
  const Case c = clip(109, 6, 2);
  ChainOptions options;
  options.method = Method::kPaper;
  const ChainResult result = run_chain(c.mix, options);
  CHECK(result.drilling_found);
  CHECK(result.clicks.mean_gap_samples == doctest::Approx(c.truth.T0).epsilon(0.05));
  CHECK(si_sdr(c.clean, result.drilling.all()) > 6);
  CHECK(!run_chain(sound(2, white, 82), options).drilling_found);
}
