// Recordings as verbs read them: what was done to one is said on stderr. Thread: OFF.
#pragma once

#include <string>
#include <string_view>

#include "rigsound/analysis/recording.hpp"

namespace rigsound::tools {

/// One line on stderr when the channels of a recording were mixed down.
void tell_mix_down(const std::string& file, const analysis::Recording& recording);

/// analysis::read_recording of the whole file, and tell_mix_down.
analysis::Recording read_whole(const std::string& file, std::string_view subject);

}  // namespace rigsound::tools
