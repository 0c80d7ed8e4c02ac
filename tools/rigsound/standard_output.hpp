// Who gets standard output: the figures of a verb, or one of its files (`-`). Thread: OFF.
#pragma once

#include <cstdio>
#include <initializer_list>
#include <string>

#include "cli/verb.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::tools {

/// stdout, or stderr when one of the outputs takes that.
inline std::FILE* figures_beside(std::initializer_list<std::string> outputs) {
  for (const std::string& output : outputs)
    if (is_standard_output(output)) return stderr;
  return stdout;
}

/// Errors: cli::UsageError when the file that `option` names would go where the figures go.
inline void require_file(const std::string& option, const std::string& output) {
  if (is_standard_output(output))
    throw cli::UsageError(option, "is standard output, which the figures take, expected a file");
}

}  // namespace rigsound::tools
