// Exposure against its formulas, and the limit against a source that leaps.
#include "exposure.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

using namespace rigsound::daemon;

namespace {

constexpr double kCalibration_db = 100, kBlock_s = 64 / 48000.0;
constexpr int kBlocks = 75;  // a tenth of a second

/// A tenth of a second of a steady A-weighted level at the ear.
LevelWindow window(double power, double c_peak = 0) {
  LevelWindow w;
  w.blocks = kBlocks;
  w.sound.power = power * kBlocks;
  w.sound.fast = w.sound.slow = power;
  w.sound.c_peak = c_peak;
  return w;
}

double power_of(double db_spl) { return std::pow(10, (db_spl - kCalibration_db) / 10); }

struct Heard {
  double highest_minute_db = 0, last_db = 0, loudest_step_db = 0;
};

/// What an ear gets of a source of `level_db` at each moment, turned down as the exposure says, two windows
/// late.
Heard listen(double limit_db, double seconds, const std::function<double(double)>& level_db) {
  Exposure exposure;
  exposure.set(kCalibration_db, limit_db);
  Heard heard;
  double gains[3] = {1, 1, 1};
  for (int i = 0; i < seconds * 10; ++i) {
    const double power = power_of(level_db(i / 10.0)) * gains[0] * gains[0];
    exposure.take(window(power), kBlock_s);
    heard.highest_minute_db = std::max(heard.highest_minute_db, exposure.snapshot()->minute_db);
    heard.last_db = 10 * std::log10(power) + kCalibration_db;
    heard.loudest_step_db = std::max(heard.loudest_step_db, 20 * std::log10(exposure.gain() / gains[2]));
    gains[0] = gains[1], gains[1] = gains[2], gains[2] = exposure.gain();
  }
  return heard;
}

}  // namespace

TEST_CASE("an uncalibrated output has no exposure") {
  Exposure exposure;
  exposure.take(window(1), kBlock_s);
  CHECK_FALSE(exposure.snapshot());
  CHECK(exposure.gain() == 1);
}

TEST_CASE("an hour at 85 dB(A) is a daily exposure of 76 dB(A); a reset begins again") {
  Exposure exposure;
  exposure.set(kCalibration_db, 0);
  for (int i = 0; i < 36000; ++i) exposure.take(window(power_of(85), i == 5 ? 2 : 0.1), kBlock_s);
  ExposureSnapshot s = *exposure.snapshot();
  CHECK(s.day_db == doctest::Approx(85 - 10 * std::log10(8)).epsilon(1e-4));
  CHECK(s.minute_db == doctest::Approx(85).epsilon(1e-4));
  CHECK(s.slow_db == doctest::Approx(85).epsilon(1e-4));
  CHECK(s.peak_db == doctest::Approx(kCalibration_db + 20 * std::log10(2) + 3.01).epsilon(1e-4));
  CHECK(s.since_s == doctest::Approx(3600));
  exposure.reset();
  s = *exposure.snapshot();
  CHECK(s.day_db == 0);
  CHECK(s.peak_db == 0);
  CHECK(s.minute_db == doctest::Approx(85).epsilon(1e-4));  // what the limit is held against stays
}

TEST_CASE("what stays below the limit is left alone") {
  const Heard heard = listen(80, 600, [](double) { return 78.0; });
  CHECK(heard.last_db == doctest::Approx(78));
}

TEST_CASE("a source that is too loud is turned down to just below the limit, which is never passed") {
  for (const double level_db : {81.0, 86.0, 97.0}) {
    CAPTURE(level_db);
    const Heard heard = listen(80, 600, [level_db](double) { return level_db; });
    CHECK(heard.highest_minute_db <= 80);
    CHECK(heard.last_db == doctest::Approx(78.5).epsilon(0.003));
  }
}

TEST_CASE("nor by one that leaps, strikes or comes back") {
  CHECK(listen(80, 900, [](double t) { return t < 300 ? 78.5 : 97.0; }).highest_minute_db <= 80);
  CHECK(listen(80, 900, [](double t) { return std::fmod(t, 60) < 30 ? 95.0 : 40.0; }).highest_minute_db <=
        80);
  CHECK(listen(80, 900, [](double t) { return std::fmod(t, 1) < 0.1 ? 97.0 : 70.0; }).highest_minute_db <=
        80);
  const Heard back = listen(80, 900, [](double t) { return t < 300 ? 95.0 : 60.0; });
  CHECK(back.last_db == doctest::Approx(60));  // the gain has come back,
  CHECK(back.loudest_step_db <= 0.11);         // by 1 dB a second
}
