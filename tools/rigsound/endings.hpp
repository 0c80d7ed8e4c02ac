// The ending of an output's name says its format. Thread: OFF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigsound::tools {

/// Errors: cli::UsageError when `file` has none of the endings, such as ".wav". An empty name, standard
/// output, a pipe and a device need none.
void require_ending(const std::string& option, const std::string& file,
                    const std::vector<std::string_view>& endings);

/// The same of a sound file.
void require_sound_ending(const std::string& option, const std::string& file);

/// One line on stderr when a file does not hold what was over full scale.
void tell_clipped(const std::string& file, unsigned long long samples);

}  // namespace rigsound::tools
