// hostile_bench [BLOCKS [FIRST_SEED]]: engines against hostile states and sound sets, for as long as one has
// patience. Says at each millionth block what came of it; ends with 1 when anything did.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "engine/hostile/hostile_run.hpp"

using namespace rigsound::tests;

namespace {

constexpr std::int64_t kBlocksAnEngine = 20000, kSaidEvery = 1000000;

bool all_is_well(const HostileFindings& f) {
  return f.not_finite == 0 && f.over_ceiling == 0 && f.highest_true_peak <= 1 && f.allocations == 0 &&
         f.not_healed == 0;
}

void say(const HostileFindings& f) {
  std::printf(
      "%lld blocks, %lld engines: %lld samples not finite, %lld over the ceiling, highest true peak %.4f dB "
      "against it, %lld allocations, %lld chunks dropped, %lld engines not healed\n",
      static_cast<long long>(f.blocks), static_cast<long long>(f.engines),
      static_cast<long long>(f.not_finite), static_cast<long long>(f.over_ceiling),
      20 * std::log10(f.highest_true_peak), static_cast<long long>(f.allocations),
      static_cast<long long>(f.dropped_chunks), static_cast<long long>(f.not_healed));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t blocks = argc > 1 ? std::atoll(argv[1]) : 10 * kSaidEvery;
  std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  HostileFindings found;
  for (std::int64_t said = 0; found.blocks < blocks; ++seed) {
    HostileInput input(seed);
    run_hostile(input, kBlocksAnEngine, found);
    if (!all_is_well(found))
      return std::printf("seed %llu:\n", static_cast<unsigned long long>(seed)), say(found), 1;
    if (found.blocks / kSaidEvery > said) said = found.blocks / kSaidEvery, say(found);
  }
  say(found);
}
