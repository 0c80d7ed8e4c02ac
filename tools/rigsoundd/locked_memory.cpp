#include "locked_memory.hpp"

#include <malloc.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace rigsound::daemon {
namespace {

constexpr std::size_t kThreadStack = 1 << 20;  // locked whole, once a thread: the usual 8 MiB would be waste

/// A heap a thread would be 64 MiB of addresses each, which count as locked; the audio thread takes nothing.
void limit_heaps() {
#ifdef __GLIBC__
  ::mallopt(M_ARENA_MAX, 1);
#endif
}

void limit_stacks() {
  pthread_attr_t attributes;
  if (::pthread_attr_init(&attributes) != 0) return;
  ::pthread_attr_setstacksize(&attributes, kThreadStack);
  ::pthread_setattr_default_np(&attributes);
  ::pthread_attr_destroy(&attributes);
}

}  // namespace

// Under a limit, a lock on future pages would make a later allocation fail: worse than a page fault.
std::string lock_memory() {
  rlimit limit{};
  ::getrlimit(RLIMIT_MEMLOCK, &limit);
  if (limit.rlim_cur != RLIM_INFINITY && ::geteuid() != 0)
    return "not locked, RLIMIT_MEMLOCK is " + std::to_string(limit.rlim_cur / 1024) + " KiB";
  limit_stacks();
  limit_heaps();
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) != 0) return std::string("not locked: ") + std::strerror(errno);
  return "locked";
}

}  // namespace rigsound::daemon
