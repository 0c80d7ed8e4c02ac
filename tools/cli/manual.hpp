// What a program writes about itself when the build asks for it. Thread: OFF.
#pragma once

#include <string>

#include "cli/description.hpp"

namespace rigsound::cli {

/// `--write-man-pages .../man1` writes the pages of that section into the folder, `--write-completion
/// bash|zsh` prints one. False: `option` is neither. Errors: std::runtime_error when a page cannot be
/// written.
bool write_manual(const VerbText& program, const std::string& version, const std::string& option,
                  const std::string& word);

}  // namespace rigsound::cli
