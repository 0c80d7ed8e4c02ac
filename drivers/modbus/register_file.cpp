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
  // A write may begin and end outside of what is in use: libmodbus gets whole tables.
  const auto size = [this](Table t) { return span_[static_cast<std::size_t>(t)].count > 0 ? 0x10000 : 0; };
  mapping_.reset(modbus_mapping_new(size(Table::kCoil), size(Table::kDiscrete), size(Table::kHolding),
                                    size(Table::kInput)));
  if (!mapping_) throw std::bad_alloc();
}

bool RegisterFile::readable(Table table, const Range& range) const {
  const Range& span = span_[static_cast<std::size_t>(table)];
  return range.address >= span.address && range.address + range.count <= span.address + span.count;
}

bool RegisterFile::writable(Table table, const Range& range) const {
  return range.address + range.count <= 0x10000 &&
         std::any_of(routes_.begin(), routes_.end(), [&](const RegisterRoute& route) {
           return route.table == table && overlaps(route, range);
         });
}

std::string RegisterFile::meant_address(Table table, const Range& range) const {
  const int base = manual_base(table);
  const Range counted_from_0{static_cast<std::uint16_t>(range.address - base), range.count};
  if (range.address < base || !writable(table, counted_from_0)) return {};
  return describe(table, counted_from_0.address);
}

std::uint16_t RegisterFile::held(std::uint16_t address) const { return mapping_->tab_registers[address]; }

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
