// What the server of `rigsound studio` is told.
#pragma once

#include <filesystem>
#include <string>

namespace rigsound::studio {

struct StudioOptions {
  std::filesystem::path sound_set;   ///< folder; made by the first analysis
  std::filesystem::path recordings;  ///< folder; empty: none
  std::filesystem::path rig;         ///< rig file; empty: none
  std::string daemon;                ///< control socket; empty: none
  std::filesystem::path pages;       ///< folder of the page; empty: where it is installed or built
  int port = 0;                      ///< 0: any that is free
  int cores = 1;                     ///< jobs at once
  std::string version;               ///< of the program
};

}  // namespace rigsound::studio
