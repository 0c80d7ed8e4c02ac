// How many clients a server has, and who makes room for the next.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace rigsound {

struct Places {
  std::size_t all = 32, of_a_peer = 8;
};

/// The client that goes when one more of `peer` comes: the one of that peer that was silent longest when it
/// has all its places, else of all when none is left; end(): nobody has to. `silent_longer(a, b)`: a goes
/// before b. Clients have a `peer`. Thread: any.
template <class Clients, class SilentLonger>
auto who_makes_room(Clients& clients, const std::string& peer, Places places, SilentLonger silent_longer) {
  const auto same = [&](const auto& client) { return client.peer == peer; };
  const auto of_peer = static_cast<std::size_t>(std::count_if(clients.begin(), clients.end(), same));
  if (of_peer >= places.of_a_peer)
    return std::min_element(clients.begin(), clients.end(), [&](const auto& a, const auto& b) {
      return same(a) != same(b) ? same(a) : silent_longer(a, b);
    });
  return clients.size() < places.all ? clients.end()
                                     : std::min_element(clients.begin(), clients.end(), silent_longer);
}

}  // namespace rigsound
