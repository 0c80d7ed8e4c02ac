// Any text as a table over time (rpm tracks, clicks) and as states: read or refused, times ascending and
// finite.
#include <cmath>
#include <cstdlib>

#include "fuzz_target.hpp"
#include "memory_file.hpp"
#include "rigsound/analysis/time_table.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/session/state_table.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file(data, size);
  const auto require_ascending = [](double& last_s, double now_s) {
    if (!std::isfinite(now_s) || now_s < last_s) std::abort();
    last_s = now_s;
  };
  fuzz::accepts<InputError>([&] {
    double last_s = -HUGE_VAL;
    for (const double now_s : analysis::read_time_table(file.path(), "rpm").time_s)
      require_ascending(last_s, now_s);
  });
  fuzz::accepts<InputError>([&] {
    double last_s = -HUGE_VAL;
    for (const session::StateChange& change : session::read_states(file.path()).changes)
      require_ascending(last_s, change.time_s);
  });
  return 0;
}
