// No input, however hostile, makes a sample that is no number, a true peak that is too loud, an allocation or
// a mark that stays.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/hostile/hostile_run.hpp"

using namespace rigsound;
using namespace rigsound::tests;

TEST_CASE("hostile states and sound sets: finite, under the ceiling, no allocation, healed in 50 ms") {
  constexpr std::int64_t kHostileBlocks = 100000, kBlocksAnEngine = 5000;
  HostileFindings found;
  for (std::uint64_t seed = 1; found.blocks < kHostileBlocks; ++seed) {
    HostileInput input(seed);
    CAPTURE(seed);
    run_hostile(input, kBlocksAnEngine, found);
    REQUIRE(found.not_finite == 0);
    REQUIRE(found.over_ceiling == 0);
    REQUIRE(found.highest_true_peak <= 1);
    REQUIRE(found.allocations == 0);
    REQUIRE(found.not_healed == 0);
  }
  MESSAGE(found.blocks << " blocks of " << found.engines << " engines, " << found.dropped_chunks
                       << " chunks dropped, highest true peak " << 20 * std::log10(found.highest_true_peak)
                       << " dB against the ceiling");
}
