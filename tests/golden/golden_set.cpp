// golden_set OUT.rigset OUT.csv: what golden_render.cpp plays, as a packed sound set and the changes of the
// machine's state, for a build of the library that has neither. A line: block from which on, "set" or
// "control", name, boom, value.
#include <cstdio>
#include <exception>

#include "bench/formula_sounds.hpp"
#include "rigsound/config/packed_set.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/machine/signal.hpp"

using namespace rigsound;

namespace {

config::PackedSet golden_set() {
  const EngineOptions options = tools::full_options();
  SoundSet sounds = tools::formula_sounds(options.sample_rate);
  config::PackedSet set;
  for (const BankUse& use : sounds.uses) {
    set.parts.banks.push_back({sounds.banks[static_cast<std::size_t>(use.bank)], {}});
    config::BankEntry entry;
    entry.name = set.parts.banks.back().bank.name, entry.situation = use.situation;
    set.parts.index.banks.push_back(entry);
  }
  set.rig = config::PackedRig{options, {}};
  for (const BoomOptions& boom : options.booms)
    set.rig->boom_tools.push_back(boom.tool < 0 ? ""
                                                : sounds.tools[static_cast<std::size_t>(boom.tool)].name);
  for (const ToolModel& tool : sounds.tools) set.parts.index.tools.push_back({tool.name});
  set.parts.tools = std::move(sounds.tools);
  set.parts.diesels = std::move(sounds.diesels);
  set.parts.diesels[0].name = "diesel";  // its own has a space, which a file may not
  set.parts.index.backgrounds = {"diesel"};
  return set;
}

std::string line(int block, const char* call, std::string_view name, int boom, double value) {
  char text[128];
  std::snprintf(text, sizeof text, "%d,%s,%s,%d,%.17g\n", block, call, std::string(name).c_str(), boom,
                value);
  return text;
}

std::string golden_changes() {
  const EngineOptions options = tools::full_options();
  const int booms = static_cast<int>(options.booms.size());
  std::string lines;
  MachineState before;
  for (int block = 0; block < 60 * 48000 / options.block; ++block) {
    const MachineState state = tools::drilled_hole(block * options.block / options.sample_rate);
    for_each_signal(booms, [&](SignalId id) {
      const SignalInfo& signal = info(id.signal);
      const double value = signal.get(state, id.boom);
      if (value != signal.get(before, id.boom)) lines += line(block, "set", signal.name, id.boom, value);
    });
    for (int b = 0; b < booms; ++b)
      for (const ControlInfo& control : control_table()) {
        const float value = state.boom[b].controls.*control.field;
        if (value != before.boom[b].controls.*control.field)
          lines += line(block, "control", control.name, b, static_cast<double>(value));
      }
    before = state;
  }
  return lines;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: golden_set OUT.rigset OUT.csv\n"), 2;
  try {
    write_file(argv[1], config::packed(golden_set()));
    write_file(argv[2], golden_changes());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
