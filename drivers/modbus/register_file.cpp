#include "modbus/register_file.hpp"

#include <algorithm>
#include <new>

namespace rigsound::modbus {
namespace {

Range span_of(const std::vector<RegisterRoute>& routes, Table table) {
  int first = 0x10000, end = 0;
  for (const RegisterRoute& route : routes) {
    if (route.table != table) continue;
    first = std::min<int>(first, route.address);
    end = std::max(end, route.address + width(route));
  }
  return end == 0 ? Range{} : Range{static_cast<std::uint16_t>(first), end - first};
}

bool overlaps(const RegisterRoute& route, const Range& range) {
  return route.address < range.address + range.count && range.address < route.address + width(route);
}

bool covers(const Range& range, const RegisterRoute& route) {
  return range.address <= route.address && route.address + width(route) <= range.address + range.count;
}

}  // namespace

RegisterFile::RegisterFile(const std::vector<RegisterRoute>& routes) : routes_(routes) {
  for (int t = 0; t < 4; ++t) span_[t] = span_of(routes, static_cast<Table>(t));
  const auto start = [this](Table t) {
    return static_cast<unsigned>(span_[static_cast<std::size_t>(t)].address);
  };
  const auto count = [this](Table t) {
    return static_cast<unsigned>(span_[static_cast<std::size_t>(t)].count);
  };
  mapping_.reset(modbus_mapping_new_start_address(
      start(Table::kCoil), count(Table::kCoil), start(Table::kDiscrete), count(Table::kDiscrete),
      start(Table::kHolding), count(Table::kHolding), start(Table::kInput), count(Table::kInput)));
  if (!mapping_) throw std::bad_alloc();
}

bool RegisterFile::readable(Table table, const Range& range) const {
  const Range& span = span_[static_cast<std::size_t>(table)];
  return range.address >= span.address && range.address + range.count <= span.address + span.count;
}

bool RegisterFile::writable(Table table, const Range& range) const {
  for (int a = range.address; a < range.address + range.count; ++a) {
    const Range one{static_cast<std::uint16_t>(a), 1};
    const auto holds = [&](const RegisterRoute& route) {
      return route.table == table && overlaps(route, one);
    };
    if (std::none_of(routes_.begin(), routes_.end(), holds)) return false;
  }
  return true;
}

std::uint16_t RegisterFile::held(std::uint16_t address) const {
  return mapping_->tab_registers[address - mapping_->start_registers];
}

std::optional<Refusal> RegisterFile::check(const Request& request, Exchange& change) const {
  change = {};
  if (request.read && !readable(request.table, *request.read)) return Refusal::kAddress;
  if (!request.write) return std::nullopt;
  if (!writable(request.table, *request.write)) return Refusal::kAddress;
  change.table = request.table;
  change.written = true;
  change.address = request.write->address;
  change.values = request.values;
  if (request.masked) {
    const int kept = held(change.address) & request.and_mask;
    change.values = {static_cast<std::uint16_t>(kept | (request.or_mask & ~request.and_mask))};
  }
  return check_values(change);
}

// Half a 32-bit value would be a wrong value until the other half comes, so it is refused.
std::optional<Refusal> RegisterFile::check_values(const Exchange& change) const {
  const Range range{change.address, static_cast<int>(change.values.size())};
  for (const RegisterRoute& route : routes_) {
    if (route.table != change.table || !overlaps(route, range)) continue;
    if (!covers(range, route)) return Refusal::kValue;
    const double value = decode(route, &change.values[route.address - change.address]);
    if (!info(route.target.signal).takes(value)) return Refusal::kValue;
  }
  return std::nullopt;
}

}  // namespace rigsound::modbus
