#include "kept_memory.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <cstdlib>

namespace rigsound::tools {
namespace {

#ifdef __GLIBC__
/// A stretch of the heap, taken and given back: what lies there later is cleared in few large pages.
void ask_for_large_pages(std::size_t size) {
  constexpr std::size_t kLargePage = 2 << 20;
  void* const stretch = std::aligned_alloc(kLargePage, size - 2 * kLargePage);
  if (stretch) madvise(stretch, size - 2 * kLargePage, MADV_HUGEPAGE);
  std::free(stretch);
}
#endif

}  // namespace

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kKept = 32 << 20;  // the most that the allocator takes
  mallopt(M_MMAP_THRESHOLD, kKept);
  mallopt(M_TRIM_THRESHOLD, kKept);
  ask_for_large_pages(kKept);
#endif
}

}  // namespace rigsound::tools
