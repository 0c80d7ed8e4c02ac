#include "read_recording.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigsound::tools {

void tell_how_read(const std::string& file, const analysis::Recording& recording) {
  for (const std::string& note : analysis::reading_notes(file, recording)) fmt::print(stderr, "{}\n", note);
}

analysis::Recording read_stretch(const std::string& file, const analysis::ChooseStretch& choose,
                                 std::string_view subject) {
  analysis::Stretch heard;
  double recording_s = 0;
  analysis::Recording recording = analysis::read_recording(
      file, [&](double seconds) { return heard = choose(recording_s = seconds); }, subject);
  tell_how_read(file, recording);
  if (heard.start_s > 0 || heard.end_s < recording_s)
    fmt::print(stderr, "{}: of its {:.0f} s those from {:.1f} to {:.1f} s are learned from\n", file,
               recording_s, heard.start_s, heard.end_s);
  return recording;
}

analysis::Recording read_whole(const std::string& file, std::string_view subject) {
  analysis::Recording recording = analysis::read_recording(file, analysis::Stretch{}, subject);
  tell_how_read(file, recording);
  return recording;
}

}  // namespace rigsound::tools
