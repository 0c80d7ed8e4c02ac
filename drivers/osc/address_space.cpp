#include "rigsound/osc/address_space.hpp"

#include <lo/lo.h>

#include <algorithm>

namespace rigsound::osc {
namespace {

constexpr int kMostStars = 3;

}  // namespace

std::string path_of(const std::string& name) {
  std::string path = "/rigsound/" + name;
  std::replace(path.begin(), path.end(), '.', '/');
  return path;
}

AddressSpace::AddressSpace(const OscOptions& options) {
  for (const udp::NameRoute& route : options.routes)
    for (const std::string& name : {route.name, route.alias})
      if (!name.empty())
        entries_.push_back({path_of(name), {Target::Kind::kSignal, route.target, nullptr, 0}});
  for (std::size_t b = 0; b < options.booms.size(); ++b)
    for (const ControlInfo& control : control_table())
      for (const std::string& of : {std::string(), options.booms[b] + "."})
        entries_.push_back({path_of(of + std::string(control.name)),
                            {Target::Kind::kControl, {}, &control, static_cast<int>(b)}});
  entries_.push_back({path_of("mute"), {}});
}

std::vector<Target> AddressSpace::find(const std::string& path) const {
  // liblo tries every way to place the stars.
  if (std::count(path.begin(), path.end(), '*') > kMostStars) return {};
  const bool pattern = path.find_first_of("*?[]{}") != std::string::npos;
  std::vector<Target> found;
  for (const Entry& entry : entries_)
    if (pattern ? lo_pattern_match(entry.path.c_str(), path.c_str()) != 0 : entry.path == path)
      found.push_back(entry.target);
  return found;
}

}  // namespace rigsound::osc
