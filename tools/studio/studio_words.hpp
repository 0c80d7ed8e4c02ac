// The command line of `rigsound studio`, which two programs read: `rigsound`, which shows its help and goes
// on as the other, and `rigsound-studio`, which does the work and alone carries what a web server needs.
#pragma once

#include <functional>
#include <string>

#include "cli/verb.hpp"
#include "studio/server/studio_options.hpp"

namespace rigsound::studio {

struct StudioWords {
  std::string sound_set, recordings, rig, page, pages;
  StudioOptions options;
};

/// Adds the verb; `run` is called when it is given. Thread: OFF.
void add_studio_words(cli::Verb& program, std::function<void(const StudioWords&)> run);

}  // namespace rigsound::studio
