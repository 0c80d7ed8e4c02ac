// What a background model sounds like, into a WAV. Thread: OFF.
#pragma once

#include <string>

#include "cli/verb.hpp"
#include "rigsound/sound_set.hpp"

namespace rigsound::tools {

struct ResynthesisOptions {
  std::string file, track;
  double seconds = 10, rpm = 0, load = -1, feed = 0;
  unsigned seed = 1;
};

void add_resynthesis_options(cli::Verb& verb, ResynthesisOptions& o);

/// Errors: InputError for the track, DeviceError for the file.
void write_resynthesis(const ResynthesisOptions& o, const DieselModel& model);

}  // namespace rigsound::tools
