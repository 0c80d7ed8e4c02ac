// What the verbs that analyse take lies in large pages.
#include "kept_memory.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace rigsound::tools;

namespace {

bool holds(const std::string& line, std::uintptr_t address) {
  std::uintptr_t begin = 0, end = 0;
  char dash = 0;
  return std::istringstream(line) >> std::hex >> begin >> dash >> end && dash == '-' && begin <= address &&
         address < end;
}

/// Flags of the mapping that holds the address, as /proc/self/smaps has them.
std::string flags_of(const void* address) {
  std::ifstream maps("/proc/self/smaps");
  std::string line;
  for (bool here = false; std::getline(maps, line);) {
    here = here || holds(line, reinterpret_cast<std::uintptr_t>(address));
    if (here && line.rfind("VmFlags:", 0) == 0) return line;
  }
  return {};
}

}  // namespace

TEST_CASE("megabytes taken after keep_freed_memory() may lie in large pages") {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) {
    MESSAGE("skipped: this kernel has no large pages");
    return;
  }
  keep_freed_memory();
  const std::vector<char> taken(16 << 20, 1);
  CHECK(flags_of(taken.data() + taken.size() / 2).find(" hg") != std::string::npos);
}
