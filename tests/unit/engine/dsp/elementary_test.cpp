#include "rigsound/dsp/elementary.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/random.hpp"

using namespace rigsound;

namespace {

/// Largest error of `ours` against `truth` over random arguments in [low, high].
template <class Ours, class Truth>
double worst(Ours ours, Truth truth, double low, double high, bool relative) {
  const dsp::RandomField random(1, 99);
  double error = 0;
  for (std::uint64_t i = 0; i < 200000; ++i) {
    const double x = low + (high - low) * random.uniform(i, 0);
    const double e = std::fabs(ours(x) - truth(x));
    error = std::max(error, relative ? e / std::fabs(truth(x)) : e);
  }
  return error;
}

/// Mean error over random arguments of [low, high], against the extended precision of `truth`: rounding
/// cancels, a wrong term does not.
template <class Ours, class Truth>
double bias(Ours ours, Truth truth, double low, double high) {
  const dsp::RandomField random(3, 5);
  constexpr int kCount = 40000;
  long double sum = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const double x = low + (high - low) * random.uniform(i, 0);
    sum += static_cast<long double>(ours(x)) - truth(static_cast<long double>(x));
  }
  return static_cast<double>(sum / kCount);
}

}  // namespace

TEST_CASE("elementary functions agree with libm to a few units in the last place") {
  CHECK(worst(
            dsp::exp, [](double x) { return std::exp(x); }, -700, 700, true) < 1e-15);
  CHECK(worst(
            dsp::log, [](double x) { return std::log(x); }, 1e-300, 1e-3, true) < 1e-15);
  CHECK(worst(
            dsp::log, [](double x) { return std::log(x); }, 0.5, 2, false) < 4e-16);
  CHECK(worst(
            dsp::sin, [](double x) { return std::sin(x); }, -1e4, 1e4, false) < 1e-15);
  CHECK(worst(
            dsp::cos, [](double x) { return std::cos(x); }, -1e4, 1e4, false) < 1e-15);
  CHECK(worst(
            dsp::atan, [](double x) { return std::atan(x); }, -30, 30, false) < 1e-15);
}

TEST_CASE("the last term of every series counts where it is largest") {
  const auto sine = [](long double x) { return std::sin(x); };
  const auto cosine = [](long double x) { return std::cos(x); };
  const auto exponential = [](long double x) { return std::exp(x); };
  const auto logarithm = [](long double x) { return std::log(x); };
  // Flipping the sign of that term adds 1.8e-16, 1.4e-17, 5e-17; of the last but one of the cosine 1e-15.
  CHECK(std::fabs(bias(dsp::exp, exponential, 0.30, 0.34)) < 2e-17);
  CHECK(std::fabs(bias(dsp::exp, exponential, -0.34, -0.30)) < 2e-17);
  CHECK(std::fabs(bias(dsp::log, logarithm, 1.38, 1.41)) < 2e-18);
  CHECK(std::fabs(bias(dsp::log, logarithm, 0.71, 0.73)) < 2e-18);
  CHECK(std::fabs(bias(dsp::sin, sine, 0.74, 0.785)) < 1.5e-17);
  CHECK(std::fabs(bias(dsp::sin, sine, -0.785, -0.74)) < 1.5e-17);
  CHECK(std::fabs(bias(dsp::cos, cosine, 0.74, 0.785)) < 1e-17);
}

TEST_CASE("sine and cosine together are the sine and the cosine, bit for bit") {
  const dsp::RandomField random(2, 7);
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double x = (random.uniform(i, 0) - 0.5) * (i % 2 == 0 ? 20 : 2e4);
    const dsp::SinCos both = dsp::sin_cos(x);
    CHECK(both.sin == dsp::sin(x));
    CHECK(both.cos == dsp::cos(x));
  }
}

TEST_CASE("atan2 covers all quadrants") {
  for (int i = 0; i < 360; i += 5) {
    const double angle = (i - 179) * dsp::kPi / 180;
    CHECK(dsp::atan2(std::sin(angle), std::cos(angle)) == doctest::Approx(angle).epsilon(1e-14));
  }
}

TEST_CASE("atan2 on the axes, and of nothing") {
  CHECK(dsp::atan2(0, 0) == 0);
  CHECK(dsp::atan2(0, 2) == 0);
  CHECK(dsp::atan2(3, 0) == dsp::kPi / 2);
  CHECK(dsp::atan2(-3, 0) == -dsp::kPi / 2);
  CHECK(dsp::atan2(0, -2) == doctest::Approx(dsp::kPi).epsilon(1e-15));
  CHECK(dsp::atan2(-1e-300, -2) == doctest::Approx(-dsp::kPi).epsilon(1e-15));
}

TEST_CASE("edges: nothing turns into NaN or infinity") {
  CHECK(dsp::exp(-1e9) == 0);
  CHECK(dsp::exp(-708) == 0);
  CHECK(dsp::exp(-707.99) == doctest::Approx(std::exp(-707.99)));
  CHECK(dsp::exp(std::nan("")) == 0);
  CHECK(dsp::exp(1e9) == dsp::exp(708));
  CHECK(std::isfinite(dsp::exp(1e9)));
  CHECK(dsp::log(0) == -745);
  CHECK(dsp::log(-1) == -745);
  CHECK(dsp::log(std::nan("")) == -745);
  CHECK(dsp::log(2.2250738585072014e-308) == doctest::Approx(-708.3964185322641));
  CHECK(dsp::log(5e-324) == doctest::Approx(-744.4400719213812));
  CHECK(dsp::gain_of_db(20) == doctest::Approx(10).epsilon(1e-14));
  CHECK(dsp::db_of_gain(0.5) == doctest::Approx(-6.020599913279624).epsilon(1e-14));
}

TEST_CASE("random fields: moments of the normal, independence of streams, repeatable") {
  const dsp::RandomField a(5, 1, 0), b(5, 1, 1);
  double mean = 0, square = 0, cross = 0, lag = 0, last = 0;
  constexpr int kCount = 200000;
  for (int i = 0; i < kCount; ++i) {
    const auto index = static_cast<std::uint64_t>(i);
    const double x = a.normal(index, 0), y = b.normal(index, 0);
    mean += x, square += x * x, cross += x * y, lag += x * last, last = x;
  }
  const double sigma = 1 / std::sqrt(kCount);  // of each of the averages below
  CHECK(std::fabs(mean / kCount) < 4 * sigma);
  CHECK(std::fabs(square / kCount - 1) < 4 * sigma * std::sqrt(2.0));
  CHECK(std::fabs(cross / kCount) < 4 * sigma);
  CHECK(std::fabs(lag / kCount) < 4 * sigma);
  CHECK(a.bits(3, 4) == dsp::RandomField(5, 1, 0).bits(3, 4));
}
