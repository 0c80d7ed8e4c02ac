#include "modbus/poll_plan.hpp"

#include <algorithm>
#include <utility>

#include "rigsound/modbus/exchange.hpp"

namespace rigsound::modbus {
namespace {

constexpr int kLongest = 125;  // registers a read (Modbus application protocol 6.3); bits could be more
constexpr int kGap = 8;        // reading so many unused registers costs less than another request

}  // namespace

std::vector<PollRequest> poll_plan(const std::vector<RegisterRoute>& routes) {
  std::vector<RegisterRoute> sorted = routes;
  std::sort(sorted.begin(), sorted.end(), [](const RegisterRoute& a, const RegisterRoute& b) {
    return std::make_pair(a.table, a.address) < std::make_pair(b.table, b.address);
  });
  std::vector<PollRequest> plan;
  for (const RegisterRoute& route : sorted) {
    const int end = route.address + width(route);
    if (!plan.empty() && plan.back().table == route.table) {
      PollRequest& last = plan.back();
      const bool near = route.address - (last.address + last.count) <= kGap;
      if (near && end - last.address <= kLongest) {
        last.count = std::max(last.count, end - last.address);
        continue;
      }
    }
    plan.push_back({route.table, route.address, width(route)});
  }
  return plan;
}

}  // namespace rigsound::modbus
