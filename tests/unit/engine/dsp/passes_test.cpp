// The passes over samples, against their formulas and at each vector width.
#include "rigsound/dsp/passes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rigsound/dsp/random.hpp"

using namespace rigsound::dsp;

namespace {

constexpr int kCount = 32;

/// Noise of about +-1 with a peak or two.
std::vector<double> drawn(std::uint64_t stream, int count = kCount) {
  const RandomField random(7, stream);
  std::vector<double> x;
  for (std::uint64_t n = 0; n < static_cast<std::uint64_t>(count); ++n)
    x.push_back(random.normal(n, 0) * (n == 13 ? -5 : 1));
  return x;
}

std::vector<Lanes> frames_of(std::uint64_t stream) {
  const auto left = drawn(stream), right = drawn(stream + 1);
  std::vector<Lanes> frames;
  for (std::size_t n = 0; n < left.size(); ++n) frames.push_back(Lanes{left[n], right[n]});
  return frames;
}

/// Calls `check` with the passes of each width that this processor has.
template <class Check>
void at_each_width(Check check) {
  check(Passes<LaneWidth::kTwo>());
  with_widest<Passes>([&](auto passes) { check(passes); });
}

bool same(Lanes a, Lanes b) { return a[0] == b[0] && a[1] == b[1]; }
bool same(const Squares& a, const Squares& b) { return same(a.sum, b.sum) && same(a.most, b.most); }

}  // namespace

TEST_CASE("a pass adds what is scaled, for any count, and nothing beyond it") {
  const auto before = drawn(1, 40);
  const auto doubles = drawn(2, 40);
  const std::vector<float> x(doubles.begin(), doubles.end());
  at_each_width([&](auto passes) {
    for (int count = 0; count <= 35; ++count) {
      auto out = before;
      passes.add_scaled(0.3, x.data(), count, out.data());
      for (std::size_t n = 0; n < out.size(); ++n) {
        const double added = static_cast<int>(n) < count ? 0.3 * static_cast<double>(x[n]) : 0.0;
        CHECK(out[n] == before[n] + added);
      }
    }
  });
}

TEST_CASE("a pass places signals of one channel on two") {
  const auto a = drawn(3), b = drawn(4), c = drawn(5);
  const Placed first{a.data(), {0.25, -0.75}}, second{b.data(), {0.5, 0.125}}, third{c.data(), {-1.5, 0.7}};
  at_each_width([&](auto passes) {
    std::vector<Lanes> one(kCount), three(kCount);
    passes.place(first, kCount, one.data());
    passes.place(first, second, kCount, three.data());
    passes.add_placed(third, kCount, three.data());
    for (std::size_t n = 0; n < one.size(); ++n)
      for (int channel = 0; channel < 2; ++channel) {
        const double placed = first.gains[channel] * a[n];
        const double heard = one[n][channel], mixed = three[n][channel];
        CHECK(heard == placed);
        CHECK(mixed == placed + second.gains[channel] * b[n] + third.gains[channel] * c[n]);
      }
  });
}

TEST_CASE("a pass sums squares and finds the largest, of even and of odd samples") {
  const auto x = drawn(6);
  double sum[2] = {}, most[2] = {};
  for (std::size_t n = 0; n < x.size(); ++n)
    sum[n % 2] += x[n] * x[n], most[n % 2] = std::max(most[n % 2], x[n] * x[n]);
  const Squares two = Passes<LaneWidth::kTwo>::squares(x.data(), kCount);
  at_each_width([&](auto passes) {
    const Squares squares = passes.squares(x.data(), kCount);
    for (int lane = 0; lane < 2; ++lane) {
      const double added = squares.sum[lane], largest = squares.most[lane];
      CHECK(added == doctest::Approx(sum[lane]).epsilon(1e-14));
      CHECK(largest == most[lane]);
    }
    CHECK(same(squares, two));
  });
}

TEST_CASE("a pass rounds frames to single precision, and measures them before") {
  const auto frames = frames_of(8);
  std::vector<double> samples;
  for (const Lanes& frame : frames) samples.insert(samples.end(), {frame[0], frame[1]});
  std::vector<float> unused(2 * kCount);
  const Squares two = Passes<LaneWidth::kTwo>::narrow(frames.data(), kCount, unused.data());
  at_each_width([&](auto passes) {
    std::vector<float> out(2 * kCount);
    const Squares squares = passes.narrow(frames.data(), kCount, out.data());
    for (std::size_t i = 0; i < out.size(); ++i) CHECK(out[i] == static_cast<float>(samples[i]));
    CHECK(same(squares, two));
    CHECK(same(squares, passes.squares(samples.data(), 2 * kCount)));
  });
}

TEST_CASE("a pass finds the highest magnitude of each eight frames, whichever of the sixteen samples it is") {
  at_each_width([](auto passes) {
    for (int place = 0; place < 2 * kCount; ++place) {
      std::vector<Lanes> frames(kCount, Lanes{0.5, -0.5});
      frames[static_cast<std::size_t>(place / 2)][place % 2] = place % 3 == 0 ? -0.75 : 0.75;
      double highest[kCount / 8] = {};
      passes.highest_of_eights(frames.data(), kCount, highest);
      for (int group = 0; group < kCount / 8; ++group)
        CHECK(highest[group] == (place / 16 == group ? 0.75 : 0.5));
    }
  });
}
