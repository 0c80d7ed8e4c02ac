// The slow noise: when a frame takes what the machine does, and that it never falls behind what is heard.
#include "diesel/low_layer.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "diesel/diesel_layer.hpp"
#include "engine/diesel/bare_diesel.hpp"
#include "engine/heard.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

namespace {

/// Silent without load, loud under full load.
DieselModel loaded() {
  DieselModel model = bare_diesel(1200);
  model.points.push_back(model.points[0]);
  model.points[1].load = 1;
  for (float& variance : model.points[1].low_variance) variance = 1e-4F;
  return model;
}

}  // namespace

TEST_CASE("a frame is what the machine did a sixteenth into the one before") {
  const DieselModel model = loaded();
  const OperatingGrid grid(model, kRate);
  const int P = model.low_channels;
  // Power of the second hop: full load from angle sample `from` to `to` of the first.
  const auto heard = [&](int from, int to) {
    LowLayer layer(model, 1);
    for (int end = 1; end <= P; ++end)
      layer.produce(end, grid, grid.place(1200, end >= from && end < to ? 1 : 0));
    layer.produce(P + 1, grid, grid.place(1200, 0));
    std::vector<float> hop(static_cast<std::size_t>(P));
    layer.ring().read(P, P, hop.data());
    double power = 0;
    for (const float x : hop) power += static_cast<double>(x) * static_cast<double>(x);
    return power;
  };
  CHECK(heard(2, P / 16) < 1e-15);
  CHECK(heard(P / 16 + 1, P + 1) < 1e-15);
  CHECK(heard(P / 16, P / 16 + 1) > 1e-9);
}

TEST_CASE("the slow noise is as loud at every angle of the crank") {
  DieselModel model = bare_diesel(1200);
  for (float& variance : model.points[0].low_variance) variance = 1e-4F;
  constexpr int kCycle = 4800, kCycles = 5, kParts = 12, kPart = kCycle / kParts, kLayers = 60;
  std::vector<double> power(kParts, 0.0);
  double all = 0;
  for (std::uint64_t seed = 0; seed < kLayers; ++seed) {
    DieselLayer layer({model}, kRate, seed, 100);
    std::vector<double> x(kCycle * kCycles);
    double settling[kChunk];
    for (int chunk = 0; chunk < 750; ++chunk) layer.process({1200, 0, 0}, settling);
    for (int n = 0; n < kCycle * kCycles; n += kChunk)
      layer.process({1200, 0, 0}, &x[static_cast<std::size_t>(n)]);
    for (std::size_t n = 0; n < x.size(); ++n) {
      power[n % kCycle / kPart] += x[n] * x[n];
      all += x[n] * x[n];
    }
  }
  for (int part = 0; part < kParts; ++part) {
    CAPTURE(part);
    CHECK(power[static_cast<std::size_t>(part)] * kParts / all == doctest::Approx(1).epsilon(0.2));
  }
}

TEST_CASE("the noise of a channel lies at its own frequency, whichever channel it is") {
  for (const std::size_t q : {3UL, 16UL, 37UL, 60UL}) {
    DieselModel model = bare_diesel(1200);
    const auto P = static_cast<std::size_t>(model.low_channels);
    for (int row = 0; row <= model.low_scales; ++row)
      model.points[0].low_variance[q + static_cast<std::size_t>(row) * P] = 1e-2F;
    DieselLayer layer({model}, kRate, 1, 100);
    std::vector<double> x(3 * 48000);
    for (std::size_t n = 0; n < x.size(); n += kChunk) layer.process({1200, 0, 0}, &x[n]);
    // Per sample it turns by its mean frequency: half an order, 5 Hz, a channel.
    double now = 0, turned = 0;
    for (std::size_t n = 48000; n + 1 < x.size(); ++n) {
      now += x[n] * x[n];
      const double step = x[n + 1] - x[n - 1];
      turned += step * step / 4;
    }
    CAPTURE(q);
    REQUIRE(now > 0);
    const double hz = std::asin(std::sqrt(turned / now)) * kRate / (2 * M_PI);
    CHECK(hz == doctest::Approx((static_cast<double>(q) + 0.5) * 5).scale(0).epsilon(0.1));
  }
}
