// Everything the ringing bar promises, measured: wanted | reached. With `cost` only the nanoseconds.
#include <cstring>

#include "bench/tool/rows.hpp"

using namespace rigsound;

int main(int count, char** arguments) {
  const bool all = count < 2 || std::strcmp(arguments[1], "cost") != 0;
  if (all) bench::print_tuning();
  if (all) bench::print_sound();
  bench::print_cost();
  return 0;
}
