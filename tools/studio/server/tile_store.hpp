// Tiles of recordings, made once: in memory while they are looked at, on disk beside the sound set.
#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "folder.hpp"
#include "recordings.hpp"
#include "rigsound/analysis/overview.hpp"

namespace rigsound::studio {

struct Tile {
  std::string bytes;
  bool exact = true;
};

/// Thread: any.
class TileStore {
 public:
  /// `sound_set`: .cache in it, bounded; what cannot be kept there is made anew.
  explicit TileStore(const Folder& sound_set) : sound_set_(sound_set) {}
  ~TileStore();

  /// Errors: ApiError 404 for a tile behind the end, InputError when the recording cannot be read.
  Tile peaks(const RecordingFile& recording, const analysis::TilePlace& place);
  Tile spectrogram(const RecordingFile& recording, const analysis::TilePlace& place);

 private:
  /// What is known of one recording.
  struct Known {
    std::mutex mutex;
    std::shared_ptr<const analysis::PeakPyramid> peaks;
    std::string failure;  // of reading all of it
    double loudest = -1;  // negative: not yet known
    bool reading = false;
  };

  std::shared_ptr<Known> known(const RecordingFile& recording);
  void read_all(const RecordingFile& recording, const std::shared_ptr<Known>& known);
  void begin_reading(const RecordingFile& recording, const std::shared_ptr<Known>& known);
  double loudest(analysis::SoundReader& sound, Known& known);

  std::filesystem::path kept(const RecordingFile& recording, const std::string& name) const;
  std::string load(const RecordingFile& recording, const std::string& name) const;
  void keep(const RecordingFile& recording, const std::string& name, const std::string& bytes);
  void make_room();

  const Folder& sound_set_;
  std::mutex mutex_;
  std::list<std::pair<std::string, std::shared_ptr<Known>>> recordings_;  // by hash, latest first
  std::list<std::thread> readers_;
  std::uintmax_t kept_bytes_ = 0;
  bool counted_ = false, ends_ = false;
};

}  // namespace rigsound::studio
