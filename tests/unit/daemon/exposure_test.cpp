// Exposure against its formulas, and the limit against a source that leaps.
#include "exposure.hpp"

#include <doctest/doctest.h>

#include <algorithm>
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

TEST_CASE("the minute's average follows with 60 s, whatever the length of a window") {
  for (const int blocks : {75, 750, 1}) {
    CAPTURE(blocks);
    Exposure exposure;
    exposure.set(kCalibration_db, 0);
    LevelWindow w;
    w.blocks = static_cast<std::uint64_t>(blocks);
    w.sound.power = power_of(85) * blocks;
    w.sound.fast = power_of(90), w.sound.slow = power_of(87);
    exposure.take(w, kBlock_s);
    const double seconds = blocks * kBlock_s;
    const ExposureSnapshot s = *exposure.snapshot();
    CHECK(s.since_s == doctest::Approx(seconds).epsilon(1e-9));
    CHECK(s.minute_db == doctest::Approx(std::max(0.0, 85 + 10 * std::log10(1 - std::exp(-seconds / 60)))));
    CHECK(s.day_db == doctest::Approx(std::max(0.0, 85 + 10 * std::log10(seconds / (8 * 3600)))));
    CHECK(s.fast_db == doctest::Approx(90));
    CHECK(s.slow_db == doctest::Approx(87));
  }
}

TEST_CASE("silence reads 0 dB everywhere, a window without blocks says nothing") {
  Exposure exposure;
  exposure.set(kCalibration_db, 0);
  exposure.take(window(0), kBlock_s);
  ExposureSnapshot s = *exposure.snapshot();
  for (const double db : {s.fast_db, s.slow_db, s.minute_db, s.day_db, s.peak_db, s.turned_down_db}) {
    CHECK(db == 0);
    CHECK_FALSE(std::signbit(db));
  }
  exposure.take(window(power_of(20), 1e-9), kBlock_s);  // far below 0 dB of a day, and a peak below it too
  s = *exposure.snapshot();
  CHECK(s.day_db == 0);
  CHECK(s.peak_db == 0);
  const double before = s.minute_db, since = s.since_s;
  LevelWindow none;
  none.sound.fast = 5, none.sound.c_peak = 5;
  exposure.take(none, kBlock_s);
  s = *exposure.snapshot();
  CHECK(s.minute_db == before);
  CHECK(s.since_s == since);
  CHECK(s.fast_db < 90);
  CHECK(s.peak_db < 90);
}

TEST_CASE("the peak is the highest of all windows, quieter ones leave it") {
  Exposure exposure;
  exposure.set(kCalibration_db, 0);
  for (const double peak : {0.1, 0.5, 0.2}) exposure.take(window(power_of(60), peak), kBlock_s);
  CHECK(exposure.snapshot()->peak_db ==
        doctest::Approx(kCalibration_db + 20 * std::log10(0.5) + 3.0103).epsilon(1e-5));
}

TEST_CASE("without a limit nothing is turned down, and one that is taken away gives all back") {
  Exposure exposure;
  exposure.set(kCalibration_db, 0);
  for (int i = 0; i < 100; ++i) exposure.take(window(power_of(120)), kBlock_s);
  CHECK(exposure.gain() == 1);
  CHECK(exposure.snapshot()->turned_down_db == 0);
  exposure.set(kCalibration_db, 80);
  for (int i = 0; i < 10; ++i) exposure.take(window(power_of(100)), kBlock_s);
  CHECK(exposure.gain() < 0.5);
  CHECK(exposure.snapshot()->turned_down_db == doctest::Approx(-20 * std::log10(exposure.gain())));
  exposure.set(kCalibration_db, 0);
  CHECK(exposure.gain() == 1);
  exposure.take(window(power_of(100)), kBlock_s);
  CHECK(exposure.gain() == 1);
}

TEST_CASE("a minute of rest may be used up in five seconds, at 12 times the target and the target itself") {
  // At rest the average is 0: a source may be as loud as 13 targets. It is turned down to just that.
  const double target_db = 80 - 1.5;
  for (const double over_db : {0.0, 5.0, 17.0}) {
    CAPTURE(over_db);
    Exposure exposure;
    exposure.set(kCalibration_db, 80);
    const double source = power_of(target_db) * 13 * std::pow(10, over_db / 10);
    LevelWindow w;
    w.blocks = 1;  // so short that the average has hardly moved
    w.sound.power = source;
    exposure.take(w, 1e-6);
    CHECK(20 * std::log10(exposure.gain()) == doctest::Approx(-over_db).scale(1).epsilon(1e-3));
  }
}

TEST_CASE("a steady source is turned down no further than it must") {
  for (const double level_db : {82.0, 88.0, 94.0}) {
    CAPTURE(level_db);
    Exposure exposure;
    exposure.set(kCalibration_db, 80);
    double quietest_db = 200;
    double gains[2] = {1, 1};
    for (int i = 0; i < 6000; ++i) {
      const double power = power_of(level_db) * gains[0] * gains[0];
      quietest_db = std::min(quietest_db, 10 * std::log10(power) + kCalibration_db);
      exposure.take(window(power), kBlock_s);
      gains[0] = gains[1], gains[1] = exposure.gain();
    }
    CHECK(quietest_db > 78.2);
  }
}

TEST_CASE("a source that pauses is remembered with 2 s, then the gain rises by 1 dB a second to 1") {
  Exposure exposure;
  exposure.set(kCalibration_db, 80);
  for (int i = 0; i < 1200; ++i) exposure.take(window(power_of(95) * std::pow(exposure.gain(), 2)), kBlock_s);
  const double down_db = exposure.snapshot()->turned_down_db;
  CHECK(down_db == doctest::Approx(95 - 78.5).epsilon(0.02));
  // Right after it has stopped the gain hardly moves: less than the memory of the source falls.
  exposure.take(window(0), kBlock_s);
  const double fallen_db = 10 / std::log(10) * 0.1 / 2;
  CHECK(down_db - exposure.snapshot()->turned_down_db <= 0.1 + 1e-9);
  double before = exposure.snapshot()->turned_down_db;
  double fastest = 0, seconds = 0;
  while (exposure.gain() < 1 && seconds < 100) {
    exposure.take(window(0), kBlock_s);
    const double now = exposure.snapshot()->turned_down_db;
    fastest = std::max(fastest, before - now);
    before = now, seconds += 0.1;
  }
  CHECK(fastest == doctest::Approx(0.1).epsilon(1e-6));
  CHECK(fallen_db > 0.1);  // the memory is never what holds it back
  CHECK(seconds == doctest::Approx(down_db).epsilon(0.02));
}

TEST_CASE("no source, however loud, shuts the output for good") {
  Exposure exposure;
  exposure.set(kCalibration_db, 40);
  for (int i = 0; i < 600; ++i) exposure.take(window(power_of(240)), kBlock_s);
  CHECK(exposure.gain() == doctest::Approx(1e-3));
}

TEST_CASE("what was heard counts with the highest gain of this window and the two before") {
  Exposure exposure;
  exposure.set(kCalibration_db, 80);
  const double source = power_of(100), target = power_of(80) * std::pow(10, -0.15);
  const auto left = [&] { return 13 * target - 12 * power_of(exposure.snapshot()->minute_db); };
  // The sound follows two windows late: until then it is the same source at gain 1.
  for (int i = 0; i < 3; ++i) {
    exposure.take(window(source), kBlock_s);
    CHECK(std::pow(exposure.gain(), 2) == doctest::Approx(left() / source).epsilon(1e-4));
  }
  // A fourth window as loud was played at the first of these gains: the source is a louder one.
  const double first = exposure.gain();
  exposure.take(window(source), kBlock_s);
  CHECK(exposure.gain() < 0.5 * first);
}
