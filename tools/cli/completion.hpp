// Completion of a program's command line in bash and zsh, from what it offers. Thread: OFF.
#pragma once

#include <string>

#include "cli/description.hpp"

namespace rigsound::cli {

std::string bash_completion(const VerbText& program);
std::string zsh_completion(const VerbText& program);

}  // namespace rigsound::cli
