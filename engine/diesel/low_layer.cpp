#include "diesel/low_layer.hpp"

#include <algorithm>

namespace rigsound::diesel {
namespace {

constexpr int kGroups = WaveletTree::kGroups;

}  // namespace

LowLayer::LowLayer(const DieselModel& model, std::uint64_t seed)
    : P_(model.low_channels),
      rows_(model.low_scales + 1),
      tree_(P_, model.low_scales, seed),
      bank_(P_),
      ring_(4 * P_),
      deviation_(static_cast<std::size_t>(rows_ * P_ / kGroups)),
      slice_(static_cast<std::size_t>(P_ / kGroups)),
      X_(static_cast<std::size_t>(P_)),
      overlap_(X_.size()),
      y_(X_.size()) {}

void LowLayer::produce(std::int64_t end, const OperatingGrid& grid, const GridPlace& place) noexcept {
  const int all = kGroups + bank_.steps();
  while (ring_.end() < end) {
    work(all, grid, place);
    bank_.finish(overlap_.data(), y_.data());
    ring_.push(y_.data(), P_);
    done_ = 0;
  }
  const std::int64_t played = P_ - (ring_.end() - end);  // of the hop that plays now
  if (played * kGroups < P_) return;  // a frame is what the machine did a sixteenth into the one before
  // A cycle has time for each group, for each step of the transform, and for the block that plays the frame.
  work(static_cast<int>(std::min<std::int64_t>(all, played * (all + 1) / P_)), grid, place);
}

void LowLayer::reset() noexcept {
  tree_.reset();
  ring_.clear();
  done_ = std::min(done_, kGroups);  // transformed anew
  std::fill(X_.begin(), X_.end(), 0.0);
  std::fill(overlap_.begin(), overlap_.end(), 0.0);
}

void LowLayer::work(int due, const OperatingGrid& grid, const GridPlace& place) noexcept {
  for (; done_ < due; ++done_) {
    if (done_ == 0) place_ = place;
    if (done_ < kGroups)
      grow(done_, grid);
    else
      bank_.step(done_ - kGroups, X_.data());
  }
}

void LowLayer::grow(int group, const OperatingGrid& grid) noexcept {
  const int count = static_cast<int>(deviation_.size());
  grid.mix(place_, &OperatingState::lo, group * count, count, deviation_.data());
  tree_.produce(group, deviation_.data(), slice_.data());
  for (std::size_t i = 0; i < slice_.size(); ++i)
    X_[static_cast<std::size_t>(group) + i * kGroups] = slice_[i];
}

}  // namespace rigsound::diesel
