#include "diesel/cycle_length.hpp"

#include <algorithm>
#include <cmath>

#include "diesel/order_analysis.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kAngles = 512;               // a cycle: as fine as the crank tracker's template
constexpr double kHighestOrder_hz = 1500;  // and as high

/// Power of orders first, first + step, ... and what chance leaves of it.
struct Power {
  double found = 0, chance = 1e-30;
  double over_chance() const { return found / chance; }
};

Power power_of_orders(const Orders& orders, std::size_t first, std::size_t step) {
  Power p;
  for (std::size_t k = first; k <= orders.C.size(); k += step)
    p.found += std::norm(orders.C[k - 1]), p.chance += orders.noise[k - 1];
  return p;
}

}  // namespace

Alternation alternation_of(const Section& section) {
  CycleBlock block = cycles_of(section, section.x, 0, kAngles);
  block.open.clear();  // impacts are not locked to the crank: they are noise, which gates would hide
  const int last = std::min(kAngles / 4, static_cast<int>(kHighestOrder_hz / section.f0()));
  const Orders one = orders_of(block, 0, block.cycles, last);
  block.N *= 2, block.cycles /= 2;
  const Orders two = orders_of(block, 0, block.cycles, 2 * last);
  return {power_of_orders(one, 1, 2).over_chance(), power_of_orders(one, 2, 4).over_chance(),
          power_of_orders(two, 1, 2).over_chance()};
}

}  // namespace rigsound::analysis
