// Man pages of a program, from what its command line offers. Thread: OFF.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/description.hpp"

namespace rigsound::cli {

struct Page {
  std::string file, roff;  ///< "rigsound-render.1"
};

/// One page for the program and one for each of its verbs, whose commands stand on its page. `section`: "1",
/// "8".
std::vector<Page> man_pages(const VerbText& program, const std::string& version, const std::string& section);

}  // namespace rigsound::cli
