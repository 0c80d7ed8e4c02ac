#include "bench/tool/row.hpp"

#include <cstdio>

namespace rigsound::bench {

void print(const Row& row) {
  const bool at_most = row.bound == Bound::kAtMost;
  const bool held = at_most ? row.reached <= row.wanted : row.reached >= row.wanted;
  std::printf("%-66s | %s %-6g | %-10.4g | %-12s | %s\n", row.what.c_str(), at_most ? "<=" : ">=", row.wanted,
              row.reached, row.unit.c_str(), held ? "held" : "MISSED");
  std::fflush(stdout);
}

}  // namespace rigsound::bench
