#include <algorithm>
#include <cmath>

#include "rigsound/analysis/overview.hpp"

namespace rigsound::analysis {
namespace {

constexpr long kAllRead = 4L << 20;  // frames of a tile that are read as a whole

PeakColumn peak_of(const float* x, std::size_t count) {
  float low = 0, high = 0;
  for (std::size_t n = 0; n < count; ++n) {
    low = std::min(low, x[n]);
    high = std::max(high, x[n]);
  }
  const auto octet = [](float value) { return static_cast<std::int8_t>(std::clamp(value, -127.0F, 127.0F)); };
  return {octet(std::floor(127 * low)), octet(std::ceil(127 * high))};
}

PeakColumn joined(const PeakColumn& a, const PeakColumn& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

std::vector<PeakColumn> finest_peaks(SoundReader& sound, const Progress& progress) {
  constexpr std::size_t kBlock = 1 << 16;
  std::vector<float> block(kBlock);
  std::vector<PeakColumn> columns;
  const long frames = sound.shape().frames;
  columns.reserve(static_cast<std::size_t>(frames / kColumnFrames + 1));
  for (long at = 0; at < frames; at += kBlock) {
    sound.read(at, kBlock, block.data());
    const std::size_t count = static_cast<std::size_t>(std::min<long>(kBlock, frames - at));
    for (std::size_t n = 0; n < count; n += kColumnFrames)
      columns.push_back(peak_of(&block[n], kColumnFrames));
    show(progress, at, frames);
  }
  return columns;
}

PeakPyramid::PeakPyramid(std::vector<PeakColumn> finest) {
  levels_.push_back(std::move(finest));
  for (int level = 1; level <= kMostTileLevel; ++level) {
    const std::vector<PeakColumn>& below = levels_.back();
    std::vector<PeakColumn> columns((below.size() + 1) / 2);
    for (std::size_t c = 0; c < columns.size(); ++c)
      columns[c] = 2 * c + 1 < below.size() ? joined(below[2 * c], below[2 * c + 1]) : below[2 * c];
    levels_.push_back(std::move(columns));
  }
}

std::vector<PeakColumn> PeakPyramid::tile(const TilePlace& place) const {
  const std::vector<PeakColumn>& all = levels_[static_cast<std::size_t>(place.level)];
  std::vector<PeakColumn> columns(kTileColumns);
  const long first = place.tile * kTileColumns,
             end = std::min<long>(static_cast<long>(all.size()), first + kTileColumns);
  if (first < end) std::copy(all.begin() + first, all.begin() + end, columns.begin());
  return columns;
}

QuickPeaks quick_peaks(SoundReader& sound, const TilePlace& place) {
  constexpr int kSamplesOfColumn = 2;
  constexpr std::size_t kSampleFrames = 512;
  QuickPeaks peaks;
  peaks.columns.resize(kTileColumns);
  const long wide = place.column_frames(), first = place.first_frame(), frames = sound.shape().frames;
  peaks.exact = wide * kTileColumns <= kAllRead;
  std::vector<float> x(peaks.exact ? static_cast<std::size_t>(wide) : kSampleFrames);
  for (int c = 0; c < kTileColumns && first + c * wide < frames; ++c) {
    const long from = first + c * wide;
    for (int i = 0; i < (peaks.exact ? 1 : kSamplesOfColumn); ++i) {
      sound.read(from + wide * i / kSamplesOfColumn, x.size(), x.data());
      peaks.columns[c] = joined(peaks.columns[c], peak_of(x.data(), x.size()));
    }
  }
  return peaks;
}

}  // namespace rigsound::analysis
