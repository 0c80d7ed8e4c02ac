// Repetition of a waveform from click to click, against signals whose correlation is known.
#include "clicks/repetition.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "analysis/noise.hpp"

using namespace rigsound::analysis;

namespace {

constexpr int kRepeatGap = 1600;

/// Clicks kRepeatGap apart, every other one `late` samples late.
ClickTrain repeated_clicks(int clicks, int late = 0) {
  ClickTrain train;
  for (int i = 0; i < clicks; ++i) train.P.push_back(kRepeatGap * (i + 1) + (i % 2 ? late : 0));
  train.mean_gap_samples = kRepeatGap;
  return train;
}

/// wave(n, click) rings down from each click.
template <class Wave>
Eigen::ArrayXf ringing(const ClickTrain& train, Wave wave) {
  Eigen::ArrayXf x = Eigen::ArrayXf::Zero(train.P.back() + 2 * kRepeatGap);
  for (std::size_t i = 0; i < train.P.size(); ++i)
    for (int n = 0; n < kRepeatGap; ++n)
      x(train.P[i] + n) += static_cast<float>(std::exp(-n / 300.0) * wave(n, i));
  return x;
}

double same_tone(int n, std::size_t) { return std::sin(0.13 * n) + std::sin(0.31 * n); }

}  // namespace

TEST_CASE("what rings alike repeats, at even times, at uneven ones, and where onsets are a little off") {
  const ClickTrain even = repeated_clicks(20), uneven = repeated_clicks(20, 250);
  CHECK(repetition(ringing(even, same_tone), even) > 0.99);
  CHECK(repetition(ringing(uneven, same_tone), uneven) > 0.99);
  ClickTrain off = even;
  for (std::size_t i = 0; i < off.P.size(); ++i) off.P[i] += i % 2 ? 15 : -15;
  CHECK(repetition(ringing(even, same_tone), off) > 0.95);
}

TEST_CASE("a tone that goes on is repeated, whatever its clicks are") {
  const ClickTrain train = repeated_clicks(20);
  Eigen::ArrayXf tone(train.P.back() + 2 * kRepeatGap);
  for (long n = 0; n < tone.size(); ++n)
    tone(n) = static_cast<float>(std::sin(2 * kPi * 90 * static_cast<double>(n) / kRepeatGap));
  CHECK(repetition(tone, train) > 0.99);
}

TEST_CASE("noise that is drawn anew with every click does not repeat") {
  TestNoise draw(3);
  const ClickTrain train = repeated_clicks(20);
  CHECK(repetition(ringing(train, [&](int, std::size_t) { return draw.normal(); }), train) < 0.4);
}

TEST_CASE("the correlation is the share of the power that repeats") {
  const ClickTrain train = repeated_clicks(30);
  TestNoise draw(5);
  const Eigen::ArrayXd once = draw.normals(kRepeatGap);
  for (const double share : {0.5, 0.8}) {
    CAPTURE(share);
    const auto wave = [&](int n, std::size_t) {
      return std::sqrt(share) * once(n) + std::sqrt(1 - share) * draw.normal();
    };
    CHECK(repetition(ringing(train, wave), train) == doctest::Approx(share).epsilon(0.12));
  }
}

TEST_CASE("three pairs are needed, and a pause is none") {
  ClickTrain train = repeated_clicks(20);
  CHECK(repetition(ringing(train, same_tone), repeated_clicks(3)) == 0);
  for (std::size_t i = 0; i < train.P.size(); ++i) train.P[i] = static_cast<int>(2 * kRepeatGap * (i + 1));
  CHECK(repetition(ringing(train, same_tone), train) == 0);
}
