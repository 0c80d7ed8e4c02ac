#include "read_recording.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigsound::tools {

void tell_how_read(const std::string& file, const analysis::Recording& recording) {
  for (const std::string& note : analysis::reading_notes(file, recording)) fmt::print(stderr, "{}\n", note);
}

analysis::Recording read_whole(const std::string& file, std::string_view subject) {
  analysis::Recording recording = analysis::read_recording(file, {}, subject);
  tell_how_read(file, recording);
  return recording;
}

}  // namespace rigsound::tools
