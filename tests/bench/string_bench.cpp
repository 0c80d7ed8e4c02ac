// Everything the drill string promises, measured: wanted | reached. `tuning`, `sound` or `cost` print only
// that.
#include <cstdlib>
#include <string>

#include "bench/string/rows.hpp"

using namespace rigsound;

int main(int count, char** arguments) {
  const std::string which = count > 1 ? arguments[1] : "";
  if (which == "workload")
    return count > 3 && bench::run_string_workload(arguments[2], std::atoi(arguments[3])) ? 0 : 1;
  if (which.empty() || which == "tuning") bench::print_string_tuning();
  if (which.empty() || which == "sound") bench::print_string_sound();
  if (which.empty() || which == "cost") bench::print_string_cost(arguments[0]);
  return 0;
}
