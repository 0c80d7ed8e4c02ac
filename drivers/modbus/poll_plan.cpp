#include "modbus/poll_plan.hpp"

#include <algorithm>
#include <utility>

#include "rigsound/modbus/exchange.hpp"

namespace rigsound::modbus {
namespace {

constexpr int kLongestRead = 125;  // registers a read (Modbus application protocol 6.3); bits could be more
constexpr int kGap = 8;            // reading so many unused registers costs less than another request

/// Values at most `gap` apart share a request; with a negative gap only those that overlap.
std::vector<PollRequest> plan_with(std::vector<RegisterRoute> sorted, int gap) {
  std::sort(sorted.begin(), sorted.end(), [](const RegisterRoute& a, const RegisterRoute& b) {
    return std::make_pair(a.table, a.address) < std::make_pair(b.table, b.address);
  });
  std::vector<PollRequest> plan;
  for (const RegisterRoute& route : sorted) {
    const int end = route.address + width(route);
    if (!plan.empty() && plan.back().table == route.table) {
      PollRequest& last = plan.back();
      const bool near = route.address - (last.address + last.count) <= gap;
      if (near && end - last.address <= kLongestRead) {
        last.count = std::max(last.count, end - last.address);
        continue;
      }
    }
    plan.push_back({route.table, route.address, width(route)});
  }
  return plan;
}

bool same(const PollRequest& a, const PollRequest& b) {
  return a.table == b.table && a.address == b.address && a.count == b.count;
}

}  // namespace

std::vector<PollRequest> poll_plan(const std::vector<RegisterRoute>& routes) {
  return plan_with(routes, kGap);
}

bool split(std::vector<PollRequest>& plan, const PollRequest& request,
           const std::vector<RegisterRoute>& routes) {
  std::vector<RegisterRoute> inside;
  for (const RegisterRoute& route : routes)
    if (route.table == request.table && route.address >= request.address &&
        route.address + width(route) <= request.address + request.count)
      inside.push_back(route);
  const auto at =
      std::find_if(plan.begin(), plan.end(), [&](const PollRequest& r) { return same(r, request); });
  std::vector<PollRequest> parts = plan_with(inside, 0);
  if (parts.size() == 1) parts = plan_with(inside, -1);
  if (parts.size() <= 1 || at == plan.end()) return false;
  plan.insert(plan.erase(at), parts.begin(), parts.end());
  return true;
}

}  // namespace rigsound::modbus
