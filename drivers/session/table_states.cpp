#include "rigsound/session/table_states.hpp"

#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::session {
namespace {

constexpr double kRounding_s = 0.5e-6;

std::uint8_t boom_named(const std::string& name, const EngineOptions& options,
                        const std::filesystem::path& file) {
  std::string known;
  for (std::size_t b = 0; b < options.booms.size(); ++b) {
    if (options.booms[b].name == name || (b == 0 && name.empty())) return static_cast<std::uint8_t>(b);
    append_to_list(known, options.booms[b].name);
  }
  throw InputError(file.string(), 0, "signal",
                   "the rig has no boom '" + name + "', expected one of: " + known);
}

}  // namespace

TableStates::TableStates(const std::filesystem::path& file, const EngineOptions& options)
    : table_(read_states(file)), block_s_(options.block / options.sample_rate) {
  std::vector<std::uint8_t> booms;
  for (const std::string& name : table_.booms) booms.push_back(boom_named(name, options, file));
  for (StateChange& change : table_.changes) change.signal.boom = booms[change.signal.boom];
}

const MachineState* TableStates::state_of(std::uint64_t number) {
  if (next_ == table_.changes.size()) return nullptr;
  const double now_s = static_cast<double>(number) * block_s_ + kRounding_s;
  for (; next_ < table_.changes.size() && table_.changes[next_].time_s <= now_s; ++next_) {
    const StateChange& change = table_.changes[next_];
    info(change.signal.signal).set(state_, change.signal.boom, change.value);
  }
  return &state_;
}

}  // namespace rigsound::session
