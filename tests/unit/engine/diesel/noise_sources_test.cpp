// The noises a diesel is made of: as loud as they are told, slow ones and those in slots.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "diesel/slot_source.hpp"
#include "diesel/wavelet_tree.hpp"
#include "engine/diesel/bare_diesel.hpp"
#include "engine/diesel/played_diesel.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

TEST_CASE("a wavelet tree with equal deviations is white, each scale brings its share") {
  constexpr int kChannels = 64, kFrames = 4096;
  for (int N : {1, 2, 3}) {
    for (int scale = 0; scale <= N + 1; ++scale) {  // N + 1: all of them
      constexpr int kWidth = kChannels / WaveletTree::kGroups;
      std::vector<double> deviation(static_cast<std::size_t>((N + 1) * kWidth), 0.0);
      for (std::size_t i = 0; i < deviation.size(); ++i)
        deviation[i] = scale == N + 1 || static_cast<int>(i) / kWidth == scale;
      WaveletTree tree(kChannels, N, 5);
      double energy = 0, neighbour = 0;
      std::vector<double> last(kChannels, 0.0), now(kChannels);
      for (int frame = 0; frame < kFrames; ++frame) {
        for (int g = 0; g < WaveletTree::kGroups; ++g)
          tree.produce(g, deviation.data(),
                       &now[static_cast<std::size_t>(g * kChannels / WaveletTree::kGroups)]);
        for (std::size_t i = 0; i < now.size(); ++i) energy += now[i] * now[i], neighbour += now[i] * last[i];
        last = now;
      }
      const double share = scale == N + 1 ? 1.0 : scale == N ? std::pow(0.5, N) : std::pow(0.5, scale + 1);
      CAPTURE(N);
      CAPTURE(scale);
      CHECK(energy / (kFrames * kChannels) == doctest::Approx(share).epsilon(0.03));
      if (scale == N + 1) CHECK(std::fabs(neighbour / energy) < 0.01);
    }
  }
}

TEST_CASE("slots give the variance they were told, slot by slot") {
  DieselModel model = bare_diesel(1200);
  const std::size_t bands = slot_band_edges(model.slot_samples()).size() - 1;
  for (std::size_t l = 0; l < 64; ++l)
    for (std::size_t b = 0; b < bands; ++b)
      model.points[0].slot_variance[l * bands + b] = l % 16 < 4 ? 4.0F : 1.0F;
  const OperatingGrid grid(model, kRate);
  SlotSource source(model, kRate, 3);
  std::vector<double> slot(static_cast<std::size_t>(model.slot_samples()));
  double loud = 0, soft = 0;
  for (int frame = 0; frame < 64 * 200; ++frame) {
    source.produce(grid, grid.place(1200, 0), 10, slot.data());
    // Hop c lies under frames c and c + 1: loud throughout for c = 0, 1, 2, soft for 4 ... 14.
    if (frame % 16 < 3) loud += power(slot) / 2400;
    if (frame % 16 >= 4 && frame % 16 < 15) soft += power(slot) / 8800;
  }
  CHECK(loud == doctest::Approx(4.0).epsilon(0.03));
  CHECK(soft == doctest::Approx(1.0).epsilon(0.03));
}

TEST_CASE("slots that vary have on average the power they were told, and neighbours vary as they are told") {
  DieselModel model = bare_diesel(1200);
  DieselPoint& p = model.points[0];
  p.slot_variance.assign(p.slot_variance.size(), 1.0F);
  const auto measured = [&](double log_variance, double correlation) {
    p.slot_log_variance.assign(64, static_cast<float>(log_variance));
    p.slot_correlation = correlation;
    const OperatingGrid grid(model, kRate);
    SlotSource source(model, kRate, 3);
    std::vector<double> slot(static_cast<std::size_t>(model.slot_samples()));
    double mean = 0, square = 0, product = 0, last = 0;
    constexpr int kFrames = 20000;
    for (int frame = 0; frame < kFrames; ++frame) {
      source.produce(grid, grid.place(1200, 0), 10, slot.data());
      const double now = power(slot);
      mean += now / kFrames, square += now * now / kFrames, product += now * last / kFrames;
      last = now;
    }
    return std::array<double, 2>{mean, (product - mean * mean) / (square - mean * mean)};
  };
  CHECK(measured(0.5, 0)[0] == doctest::Approx(1).epsilon(0.05));
  CHECK(measured(1, 0)[0] == doctest::Approx(1).epsilon(0.08));
  // Hops overlap, so that half of what one frame is loud is heard in the next anyway.
  CHECK(measured(0.5, 0)[1] < 0.6);
  CHECK(measured(0.5, 0.9)[1] > 0.8);
}
