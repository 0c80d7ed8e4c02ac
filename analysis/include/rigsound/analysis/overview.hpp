// A long recording as tiles of a map: how loud it is, and its spectrogram, at any zoom.
//
// A column of level L covers kColumnFrames * 2^L frames of the file, a tile kTileColumns of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/analysis/sound_reader.hpp"
#include "rigsound/progress.hpp"

namespace rigsound::analysis {

constexpr int kTileColumns = 1024, kColumnFrames = 64, kMostTileLevel = 20;

/// One tile of a recording.
struct TilePlace {
  int level = 0;
  long tile = 0;

  long column_frames() const { return static_cast<long>(kColumnFrames) << level; }
  long first_frame() const { return tile * kTileColumns * column_frames(); }
};

/// Lowest and highest sample of a column, full scale 127; rounded away from 0, so that nothing is hidden.
struct PeakColumn {
  std::int8_t low = 0, high = 0;
};

/// Every column of level 0. Thread: OFF.
std::vector<PeakColumn> finest_peaks(SoundReader& sound, const Progress& progress = {});

/// Every level of a recording. Thread: any, once made.
class PeakPyramid {
 public:
  /// `finest`: what finest_peaks() gave.
  explicit PeakPyramid(std::vector<PeakColumn> finest);

  /// kTileColumns columns, those behind the end 0.
  std::vector<PeakColumn> tile(const TilePlace& place) const;

  const std::vector<PeakColumn>& finest() const { return levels_.front(); }

 private:
  std::vector<std::vector<PeakColumn>> levels_;
};

/// The same tile without a pyramid: all of its samples where they are few (`exact`), else a few samples of
/// every column, of which the true peaks may lie outside. Thread: OFF.
struct QuickPeaks {
  std::vector<PeakColumn> columns;
  bool exact = true;
};
QuickPeaks quick_peaks(SoundReader& sound, const TilePlace& place);

/// Power of the loudest row of a spectrogram in windows spread evenly over the recording. Thread: OFF.
double loudest_power(SoundReader& sound);

/// PNG of kTileColumns x 256 pixels: rows log-spaced over the range of the analysis report's spectrograms,
/// its colours, the last of them at `loudest`. A column that is longer than a few windows is the mean of
/// those spread over it. Thread: OFF.
std::string spectrogram_tile(SoundReader& sound, const TilePlace& place, double loudest);

}  // namespace rigsound::analysis
