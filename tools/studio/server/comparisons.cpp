#include "comparisons.hpp"

#include <algorithm>

#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/recording.hpp"

namespace rigsound::studio {

namespace {

constexpr std::size_t kMostSides = 4;  // a minute of recorded and denoised sound is 23 MB

}  // namespace

std::shared_ptr<Comparisons::Entry> Comparisons::entry(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const auto& one) { return one.first == key; });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    entries_.emplace_front(key, std::make_shared<Entry>());
    if (entries_.size() > kMostSides) entries_.pop_back();
  }
  return entries_.front().second;
}

std::shared_ptr<const analysis::RecordedSide> Comparisons::of(const config::StoredBank& bank) {
  const config::Provenance& from = bank.provenance;
  const std::vector<RecordingFile> all = recordings_.recordings();
  const RecordingFile* const file = recordings_.find_source(all, from.source_file);
  if (file == nullptr) throw ApiError(404, "its recording is not in the folder of recordings");
  const std::shared_ptr<Entry> kept = entry(file->hash + " " + from.settings);
  const std::lock_guard lock(kept->mutex);
  if (!kept->side) {
    if (!from.source_sha256.empty() && analysis::file_sha256(file->file) != from.source_sha256)
      throw ApiError(404, "its recording has changed since the analysis");
    analysis::Recording part = analysis::read_recording(file->file, analysis::stretch_of(from.settings));
    kept->side = std::make_shared<const analysis::RecordedSide>(
        analysis::recorded_side(std::move(part.mono), analysis::chain_of(from.settings), file->name));
  }
  return kept->side;
}

}  // namespace rigsound::studio
