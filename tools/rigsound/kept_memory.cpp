#include "kept_memory.hpp"

#include <malloc.h>

namespace rigsound::tools {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kKept = 32 << 20;  // the most that the allocator takes
  mallopt(M_MMAP_THRESHOLD, kKept);
  mallopt(M_TRIM_THRESHOLD, kKept);
#endif
}

}  // namespace rigsound::tools
