// One line of the table that tool_bench prints.
#pragma once

#include <string>

namespace rigsound::bench {

enum class Bound { kAtMost, kAtLeast };

struct Row {
  std::string what;
  Bound bound = Bound::kAtMost;
  double wanted = 0, reached = 0;
  std::string unit;
};

/// `what | wanted | reached | held`.
void print(const Row& row);

}  // namespace rigsound::bench
