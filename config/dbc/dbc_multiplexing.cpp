#include "dbc/dbc_multiplexing.hpp"

#include <algorithm>
#include <set>

#include "rigsound/machine/input_error.hpp"
#include "rigsound/number_of.hpp"

namespace rigsound::config {
namespace {

using MuxBySignal = std::map<std::string, DbcMux>;

std::string plain_multiplexor(const MuxBySignal& mux) {
  const auto found = std::find_if(mux.begin(), mux.end(), [](const auto& entry) {
    return entry.second.is_multiplexor && !entry.second.is_multiplexed;
  });
  return found == mux.end() ? std::string() : found->first;
}

}  // namespace

bool parse_mux(std::string_view word, DbcMux& mux) {
  if (word == "M") return mux.is_multiplexor = true;
  if (word.size() < 2 || word.front() != 'm') return false;
  mux.is_multiplexor = word.back() == 'M';
  word.remove_prefix(1);
  if (mux.is_multiplexor) word.remove_suffix(1);
  const auto value = number_of<decltype(mux.value)>(word);
  mux.is_multiplexed = value.has_value();
  mux.value = value.value_or(0);
  return mux.is_multiplexed;
}

void resolve_multiplexing(DbcMessage& message, const MuxBySignal& mux, const std::string& file) {
  const std::string plain = plain_multiplexor(mux);
  for (DbcSignal& signal : message.signals) {
    std::set<std::string> seen;
    for (auto at = mux.find(signal.name); at != mux.end() && at->second.is_multiplexed;) {
      const DbcMux& m = at->second;
      const std::string& parent_name = m.parent.empty() ? plain : m.parent;
      const DbcSignal* parent = message.find(parent_name);
      if (parent == nullptr || !seen.insert(at->first).second)
        throw InputError(
            file, signal.line, "SG_",
            signal.name + (parent == nullptr ? " is multiplexed, but its message has no multiplexor"
                                             : " is multiplexed by a signal that depends on itself"));
      can::Selector selector{parent->layout.field, m.ranges};
      if (selector.ranges.empty()) selector.ranges.emplace_back(m.value, m.value);
      signal.layout.selectors.push_back(std::move(selector));
      at = mux.find(parent_name);
    }
  }
}

}  // namespace rigsound::config
