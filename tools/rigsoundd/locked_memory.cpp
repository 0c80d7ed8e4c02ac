#include "locked_memory.hpp"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace rigsound::daemon {

// Under a limit, a lock on future pages would make a later allocation fail: worse than a page fault.
// ONFAULT: the untouched parts of thread stacks need not be there.
std::string lock_memory() {
  rlimit limit{};
  ::getrlimit(RLIMIT_MEMLOCK, &limit);
  if (limit.rlim_cur != RLIM_INFINITY && ::geteuid() != 0)
    return "not locked, RLIMIT_MEMLOCK is " + std::to_string(limit.rlim_cur / 1024) + " KiB";
  if (::mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0)
    return std::string("not locked: ") + std::strerror(errno);
  return "locked";
}

}  // namespace rigsound::daemon
