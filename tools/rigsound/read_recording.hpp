// Recordings as verbs read them: what was done to one is said on stderr. Thread: OFF.
#pragma once

#include <string>
#include <string_view>

#include "rigsound/analysis/recording.hpp"

namespace rigsound::tools {

/// analysis::reading_notes on stderr.
void tell_how_read(const std::string& file, const analysis::Recording& recording);

/// analysis::read_recording of a stretch, and tell_how_read; when it is not the whole, that too.
analysis::Recording read_stretch(const std::string& file, const analysis::ChooseStretch& choose,
                                 std::string_view subject);

/// analysis::read_recording of the whole file, and tell_how_read.
analysis::Recording read_whole(const std::string& file, std::string_view subject);

}  // namespace rigsound::tools
