// What all routes share.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "comparisons.hpp"
#include "folder.hpp"
#include "jobs.hpp"
#include "listening_trials.hpp"
#include "recordings.hpp"
#include "studio_options.hpp"
#include "tile_store.hpp"

namespace rigsound::studio {

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
