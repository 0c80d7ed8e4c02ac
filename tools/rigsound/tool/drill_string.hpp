// `rigsound tool --string`: a drill string instead of a bar. Thread: OFF.
#pragma once

#include <string>

#include "cli/verb.hpp"
#include "rigsound/string_model.hpp"

namespace rigsound::tools {

/// What the verb asks for, be it a bar or a string.
struct ToolOutput {
  std::string name, sound_set, plot;
  double rate = 48000;
  bool json = false;
};

struct DrillStringOptions {
  StringModel model;
  double exposed_m = 0;  ///< 0: the whole rod
  std::string rock = "medium", rocks_of;
};

/// The options that need `string`.
void add_drill_string_options(cli::Verb& verb, DrillStringOptions& o, const cli::Option& string);

/// Prints the figures, draws them, adds the string to the sound set. Errors: InputError, DeviceError.
void design_drill_string(DrillStringOptions o, const ToolOutput& output);

}  // namespace rigsound::tools
