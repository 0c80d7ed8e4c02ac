#include "socket/resolve.hpp"

#include <poll.h>

#include <thread>
#include <utility>

namespace rigsound {
namespace {

/// Outlives who asked: getaddrinfo() cannot be interrupted.
struct Lookup {
  Lookup(const HostPort& where, int type, int flags) : host(where.host), port(std::to_string(where.port)) {
    hints.ai_flags = AI_NUMERICSERV | flags;
    hints.ai_socktype = type;
  }
  ~Lookup() {
    if (found != nullptr) ::freeaddrinfo(found);
  }
  Lookup(const Lookup&) = delete;
  Lookup& operator=(const Lookup&) = delete;

  void run() { error = ::getaddrinfo(host.c_str(), port.c_str(), &hints, &found); }

  std::string host, port;
  addrinfo hints{}, *found = nullptr;
  int error = 0;
  StopEvent done;
};

/// False: stopped before.
bool look_up(const std::shared_ptr<Lookup>& lookup, const StopEvent& stop) {
  std::thread([lookup] {
    lookup->run();
    lookup->done.set();
  }).detach();
  while (!lookup->done.is_set() && !stop.is_set()) stop.wait(lookup->done.to_poll().fd, POLLIN, -1);
  return lookup->done.is_set();
}

}  // namespace

Addresses resolve(const HostPort& where, int type, int flags, const StopEvent& stop, std::string& problem) {
  Addresses none(nullptr, ::freeaddrinfo);
  auto lookup = std::make_shared<Lookup>(where, type, flags | AI_NUMERICHOST);
  lookup->run();
  if (lookup->error == EAI_NONAME) {
    lookup = std::make_shared<Lookup>(where, type, flags);
    if (!look_up(lookup, stop)) {
      problem = "stopped while its name was looked up";
      return none;
    }
  }
  if (lookup->error == 0) return {std::exchange(lookup->found, nullptr), ::freeaddrinfo};
  problem = ::gai_strerror(lookup->error);
  return none;
}

}  // namespace rigsound
