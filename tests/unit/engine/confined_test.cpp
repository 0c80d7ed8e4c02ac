// Where the kernel kills who asks it for anything but to read and write, the engine plays on: `process` makes
// no call of the system, and allocates nothing.
#include <doctest/doctest.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "engine/allocation_guard.hpp"
#include "rigsound/engine.hpp"

using namespace rigsound;

namespace {

constexpr int kAllocated = 2, kNotConfined = 77;  // exit codes
constexpr int kConfinedBlocks = 100000;

/// Not exit_group, which is not allowed any more.
[[noreturn]] void leave(int code) {
  for (;;) ::syscall(SYS_exit, code);
}

/// Does `work` in a confined process; its wait status.
int confined(const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    const long before = tests::allocations();
    if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) leave(kNotConfined);
    work();
    leave(tests::allocations() == before ? 0 : kAllocated);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return status;
}

bool can_confine() {
  const int status = confined([] {});
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  MESSAGE("SKIPPED: engine_test: confined: this kernel has no strict seccomp");
  return false;
}

int confined_blocks() {
  const char* const wanted = std::getenv("RIGSOUND_CONFINED_BLOCKS");
  return wanted != nullptr ? std::atoi(wanted) : kConfinedBlocks;
}

}  // namespace

TEST_CASE("a confined process is killed at a call of the system, and an allocation is noticed") {
  if (!can_confine()) return;
  const int called = confined([] { ::syscall(SYS_getppid); });
  CHECK(WIFSIGNALED(called));
  CHECK(WTERMSIG(called) == SIGKILL);
  const int allocated = confined([] {
    int* volatile kept = new int;
    delete kept;
  });
  CHECK(WIFEXITED(allocated));
  CHECK(WEXITSTATUS(allocated) == kAllocated);
}

TEST_CASE("the engine plays whatever a rig does in a confined process") {
  if (!can_confine()) return;
  const EngineOptions options = tools::full_options();
  Engine engine(options, tools::formula_sounds());
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  const int blocks = confined_blocks();
  const int status = confined([&] {
    for (int i = 0; i < blocks; ++i) engine.process(tools::drilled_hole(i * 64 / 48000.0), block.data());
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}
