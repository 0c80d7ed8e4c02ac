#include "socket/resolve.hpp"

#include <poll.h>

#include <optional>
#include <utility>

#include "rigsound/handoff/background_job.hpp"

namespace rigsound {
namespace {

struct Lookup {
  int error = 0;
  Addresses found{nullptr, ::freeaddrinfo};
};

Lookup look_up(const HostPort& where, int type, int flags) {
  addrinfo hints{}, *found = nullptr;
  hints.ai_flags = AI_NUMERICSERV | flags;
  hints.ai_socktype = type;
  Lookup lookup;
  lookup.error = ::getaddrinfo(where.host.c_str(), std::to_string(where.port).c_str(), &hints, &found);
  lookup.found.reset(found);
  return lookup;
}

/// None: stopped before. getaddrinfo() cannot be interrupted.
std::optional<Lookup> look_up_meanwhile(const HostPort& where, int type, int flags, const StopEvent& stop) {
  BackgroundJob<Lookup> job;
  job.begin([where, type, flags] { return look_up(where, type, flags); });
  std::optional<Lookup> lookup;
  while (!(lookup = job.take()) && !stop.is_set()) stop.wait(job.to_poll().fd, POLLIN, -1);
  return lookup;
}

}  // namespace

Addresses resolve(const HostPort& where, int type, int flags, const StopEvent& stop, std::string& problem) {
  std::optional<Lookup> lookup = look_up(where, type, flags | AI_NUMERICHOST);
  if (lookup->error == EAI_NONAME) lookup = look_up_meanwhile(where, type, flags, stop);
  if (!lookup)
    problem = "stopped while its name was looked up";
  else if (lookup->error != 0)
    problem = ::gai_strerror(lookup->error);
  else
    return std::move(lookup->found);
  return {nullptr, ::freeaddrinfo};
}

}  // namespace rigsound
