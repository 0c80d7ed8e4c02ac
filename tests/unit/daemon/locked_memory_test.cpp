// Memory is locked, or the reason told why not; each try in a process of its own, whose memory it is.
#include "locked_memory.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

using rigsound::daemon::lock_memory;

namespace {

constexpr uid_t kNobody = 65534;

/// What a process of its own says.
template <class Say>
std::string said_by_child(const Say& say) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const std::string said = say();
    if (::write(ends[1], said.data(), said.size()) < 0) ::_exit(1);
    ::_exit(0);
  }
  ::close(ends[1]);
  std::array<char, 256> bytes{};
  const ssize_t got = ::read(ends[0], bytes.data(), bytes.size());
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return got > 0 ? std::string(bytes.data(), static_cast<std::size_t>(got)) : "";
}

/// What is said in a process of this user that may lock so much.
std::string said_of_memory(uid_t user, rlim_t limit) {
  return said_by_child([&] {
    const rlimit most{limit, limit};
    const bool set = ::setrlimit(RLIMIT_MEMLOCK, &most) == 0 && (::geteuid() == user || ::seteuid(user) == 0);
    return set ? lock_memory() : "not set";
  });
}

/// As /proc tells it.
long locked_kib() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (long kib = 0; word == "VmLck:" && status >> kib) return kib;
  return -1;
}

}  // namespace

TEST_CASE("A user with a limit locks nothing, and is told the limit in KiB") {
  const uid_t user = ::geteuid() == 0 ? kNobody : ::geteuid();
  CHECK(said_of_memory(user, 64 * 1024) == "not locked, RLIMIT_MEMLOCK is 64 KiB");
}

TEST_CASE("For root the limit is none: memory is locked, or the kernel says why not") {
  if (::geteuid() != 0) {
    std::puts("SKIPPED: locked_memory: only root may try");
    return;
  }
  const std::string said = said_of_memory(0, 64 * 1024);
  CHECK((said == "locked" || said.rfind("not locked: ", 0) == 0));
}

TEST_CASE(
    "a thread that takes memory adds its stack to what is locked, not the addresses of a heap of its own") {
  const std::string said = said_by_child([] {
    if (lock_memory() != "locked" || locked_kib() == 0) return std::string("not locked");
    const long before = locked_kib();
    long with_thread = 0;
    std::thread([&] {
      const std::vector<char> taken(1000);
      with_thread = locked_kib();
    }).join();
    return std::to_string(with_thread - before);
  });
  if (said == "not locked") {  // nor is it under a sanitizer
    std::puts("SKIPPED: locked_memory: it may not be locked here");
    return;
  }
  CHECK(std::stol(said) >= 1024);
  CHECK(std::stol(said) < 3 * 1024);
}
