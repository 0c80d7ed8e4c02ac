// What engine.wasm plays while one part of the sound set is worked on: that part, on one boom, with the
// options of the rig. Errors: ApiError, InputError. Thread: any.
#pragma once

#include <string>
#include <vector>

#include "rigsound/tool_model.hpp"
#include "workplace.hpp"

namespace rigsound::studio {

/// One bank, as analysed, serves every situation. `clicks`: those that stay; empty: all.
std::string packed_bank(const Workplace& place, const std::string& bank, const std::vector<int>& clicks);

/// One diesel; the hammer is silent.
std::string packed_background(const Workplace& place, const std::string& background);

/// Whose impacts strike: those of a bank, as refined; an empty `bank`: even ones, 24 a second, without
/// clicks.
struct Hammer {
  std::string bank;
  bool clicks = false;  ///< whether the bank's clicks sound too
};

/// `steel` rings under a hammer. It brings its design.
std::string packed_steel(const Workplace& place, const ToolModel& steel, const Hammer& hammer);

}  // namespace rigsound::studio
