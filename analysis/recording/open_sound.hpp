// A sound file of libsndfile, its header repaired when that is what it takes.
#pragma once

#include <sndfile.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "recording/wave_repair.hpp"

namespace rigsound::analysis {

/// Open for reading. Thread: OFF.
class OpenSound {
 public:
  /// Fills `info`. What cannot be opened leaves get() null, and sf_strerror(nullptr) says why.
  OpenSound(const std::filesystem::path& path, SF_INFO& info);

  SNDFILE* get() const { return sound_.get(); }
  const std::string& fault() const { return repaired_.repair.fault; }  ///< that was repaired; empty: none

  /// The file as its repaired header describes it.
  struct Repaired {
    WaveRepair repair;
    std::ifstream file;
    sf_count_t at = 0;
  };

 private:
  Repaired repaired_;
  std::unique_ptr<SNDFILE, decltype(&sf_close)> sound_;  // last: it is closed before what it reads from
};

}  // namespace rigsound::analysis
