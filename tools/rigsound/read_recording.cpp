#include "read_recording.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigsound::tools {

void tell_mix_down(const std::string& file, const analysis::Recording& recording) {
  const std::string note = analysis::mix_down_note(file, recording);
  if (!note.empty()) fmt::print(stderr, "{}\n", note);
}

analysis::Recording read_whole(const std::string& file, std::string_view subject) {
  analysis::Recording recording = analysis::read_recording(file, {}, subject);
  tell_mix_down(file, recording);
  return recording;
}

}  // namespace rigsound::tools
