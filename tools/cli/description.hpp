// What a command line offers, as plain data: its help, man pages and completions say the same because all
// come from here. Thread: OFF.
#pragma once

#include <string>
#include <vector>

namespace rigsound::cli {

struct OptionText {
  std::vector<std::string> names;  ///< "--out"; of a positional its one name
  std::string type;                ///< "NUMBER", "none|closed|open"; empty: a flag
  std::string initial;             ///< what holds when it is left out, when the help shows it
  std::string help;
  std::string group;  ///< of options of which exactly one is given; empty: none
  bool required = false;
};

struct VerbText {
  std::string name, summary, heading;  ///< heading: under which its parent lists it
  std::vector<OptionText> positionals, options;
  std::string details;                ///< paragraphs, one a line
  std::vector<std::string> examples;  ///< command lines
  std::vector<VerbText> verbs;
};

}  // namespace rigsound::cli
