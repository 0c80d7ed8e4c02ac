// What all routes share.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "comparisons.hpp"
#include "folder.hpp"
#include "jobs.hpp"
#include "listening_trials.hpp"
#include "recordings.hpp"
#include "tile_store.hpp"

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

struct Workplace {
  explicit Workplace(const StudioOptions& its_options)
      : options(its_options),
        sound_set(its_options.sound_set),
        recordings(its_options.recordings),
        tiles(sound_set),
        comparisons(recordings),
        jobs(its_options.cores) {}

  StudioOptions options;
  Folder sound_set;
  Recordings recordings;
  TileStore tiles;
  Comparisons comparisons;
  ListeningTrials trials;
  std::mutex writes;  ///< one write at a time: what it saw is what it replaces
  Jobs jobs;          ///< last: its work uses the others
};

}  // namespace rigsound::studio
