#include "tile_store.hpp"

#include <algorithm>
#include <vector>

#include "jobs.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;
using analysis::PeakColumn, analysis::PeakPyramid, analysis::SoundReader, analysis::TilePlace;

namespace {

constexpr std::size_t kMostInMemory = 8;         // recordings whose peaks are in memory, 11 MB an hour
constexpr std::uintmax_t kMostKept = 512 << 20;  // bytes on disk
constexpr const char *kCache = ".cache", *kPeaks = "peaks";

std::string octets(const std::vector<PeakColumn>& columns) {
  static_assert(sizeof(PeakColumn) == 2, "two octets a column");
  return {reinterpret_cast<const char*>(columns.data()), columns.size() * sizeof(PeakColumn)};
}

std::vector<PeakColumn> columns_of(const std::string& bytes) {
  std::vector<PeakColumn> columns(bytes.size() / sizeof(PeakColumn));
  std::copy_n(bytes.data(), columns.size() * sizeof(PeakColumn), reinterpret_cast<char*>(columns.data()));
  return columns;
}

void require_within(const SoundReader& sound, const TilePlace& place) {
  if (place.level < 0 || place.level > analysis::kMostTileLevel)
    throw ApiError(404, "level: expected 0 to " + std::to_string(analysis::kMostTileLevel));
  const long frames = place.column_frames() * analysis::kTileColumns;
  if (place.tile < 0 || place.tile > sound.shape().frames / frames ||
      place.first_frame() >= sound.shape().frames)
    throw ApiError(404, "tile: lies behind the end");
}

}  // namespace

TileStore::~TileStore() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  for (std::thread& reader : readers_) reader.join();
}

std::shared_ptr<TileStore::Known> TileStore::known(const RecordingFile& recording) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(recordings_.begin(), recordings_.end(),
                                  [&](const auto& one) { return one.first == recording.hash; });
  if (found != recordings_.end()) {
    recordings_.splice(recordings_.begin(), recordings_, found);
    return recordings_.front().second;
  }
  recordings_.emplace_front(recording.hash, std::make_shared<Known>());
  if (recordings_.size() > kMostInMemory) recordings_.pop_back();
  return recordings_.front().second;
}

void TileStore::read_all(const RecordingFile& recording, const std::shared_ptr<Known>& known) {
  std::shared_ptr<const PeakPyramid> peaks;
  std::string failure;
  try {
    const std::string kept = load(recording, kPeaks);
    std::vector<PeakColumn> finest = columns_of(kept);
    SoundReader sound(recording.file);
    if (static_cast<long>(finest.size()) !=
        (sound.shape().frames + analysis::kColumnFrames - 1) / analysis::kColumnFrames) {
      finest = analysis::finest_peaks(sound, [this](double) {
        const std::lock_guard lock(mutex_);
        if (ends_) throw Stopped();
      });
      keep(recording, kPeaks, octets(finest));
    }
    peaks = std::make_shared<const PeakPyramid>(std::move(finest));
  } catch (const Stopped&) {
    return;
  } catch (const std::exception& error) {
    failure = error.what();
  }
  const std::lock_guard lock(known->mutex);
  known->peaks = peaks;
  known->failure = failure;
}

void TileStore::begin_reading(const RecordingFile& recording, const std::shared_ptr<Known>& known) {
  if (std::exchange(known->reading, true)) return;
  const std::lock_guard lock(mutex_);
  readers_.emplace_back([this, recording, known] { read_all(recording, known); });
}

Tile TileStore::peaks(const RecordingFile& recording, const TilePlace& place) {
  SoundReader sound(recording.file);
  require_within(sound, place);
  const std::shared_ptr<Known> all = known(recording);
  {
    const std::lock_guard lock(all->mutex);
    if (!all->failure.empty()) throw ApiError(422, all->failure);
    if (all->peaks) return {octets(all->peaks->tile(place)), true};
    begin_reading(recording, all);
  }
  const analysis::QuickPeaks quick = quick_peaks(sound, place);
  return {octets(quick.columns), quick.exact};
}

double TileStore::loudest(SoundReader& sound, Known& known) {
  const std::lock_guard lock(known.mutex);
  if (known.loudest < 0) known.loudest = analysis::loudest_power(sound);
  return known.loudest;
}

Tile TileStore::spectrogram(const RecordingFile& recording, const TilePlace& place) {
  SoundReader sound(recording.file);
  require_within(sound, place);
  const std::string name =
      "spectrogram_" + std::to_string(place.level) + "_" + std::to_string(place.tile) + ".png";
  std::string bytes = load(recording, name);
  if (bytes.empty()) {
    bytes = analysis::spectrogram_tile(sound, place, loudest(sound, *known(recording)));
    keep(recording, name, bytes);
  }
  return {std::move(bytes), true};
}

fs::path TileStore::kept(const RecordingFile& recording, const std::string& name) const {
  return sound_set_.inside(fs::path(kCache) / recording.hash / name);
}

std::string TileStore::load(const RecordingFile& recording, const std::string& name) const {
  std::error_code none;
  const fs::path file = kept(recording, name);
  if (!fs::is_regular_file(file, none)) return "";
  return InputFile(file, "tile", kMostKept).content();
}

void TileStore::keep(const RecordingFile& recording, const std::string& name, const std::string& bytes) {
  const std::lock_guard lock(mutex_);
  try {
    const fs::path file = kept(recording, name);
    if (!fs::is_directory(sound_set_.path())) return;  // it is made by what fills it
    kept_bytes_ += bytes.size();
    if (!counted_ || kept_bytes_ > kMostKept) make_room();
    fs::create_directories(file.parent_path());
    write_file(file, bytes);
  } catch (const DeviceError&) {  // a full disk or a folder that is only read: made anew the next time
  } catch (const fs::filesystem_error&) {
  }
}

/// The oldest tiles go, until half of the room is free.
void TileStore::make_room() {
  struct Kept {
    fs::file_time_type time;
    std::uintmax_t size;
    fs::path file;
  };
  std::vector<Kept> all;
  std::error_code none;
  kept_bytes_ = 0;
  counted_ = true;
  for (fs::recursive_directory_iterator at(sound_set_.inside(kCache), none), end; at != end;
       at.increment(none)) {
    if (!at->is_regular_file(none)) continue;
    all.push_back({at->last_write_time(none), at->file_size(none), at->path()});
    kept_bytes_ += all.back().size;
  }
  if (kept_bytes_ <= kMostKept) return;
  std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.time < b.time; });
  for (const Kept& one : all) {
    if (kept_bytes_ <= kMostKept / 2) break;
    if (fs::remove(one.file, none)) kept_bytes_ -= one.size;
  }
}

}  // namespace rigsound::studio
