#include "diesel/low_layer.hpp"

#include <algorithm>

namespace rigsound::diesel {
namespace {

// A cycle has time for each group, for the transform, and for the block that plays the frame.
constexpr int kGroups = WaveletTree::kGroups, kSteps = kGroups + 2;

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
  while (ring_.end() < end) {
    grow(kGroups, grid, place);
    transform();
    bank_.finish(overlap_.data(), y_.data());
    ring_.push(y_.data(), P_);
    groups_done_ = 0, transformed_ = false;
  }
  const std::int64_t played = P_ - (ring_.end() - end);  // of the hop that plays now
  if (played * kGroups < P_) return;  // a frame is what the machine did a sixteenth into the one before
  const int due = static_cast<int>(played * kSteps / P_);
  grow(std::min(kGroups, due), grid, place);
  if (due > kGroups) transform();
}

void LowLayer::transform() noexcept {
  if (!transformed_) bank_.transform(X_.data());
  transformed_ = true;
}

void LowLayer::reset() noexcept {
  tree_.reset();
  ring_.clear();
  transformed_ = false;
  std::fill(X_.begin(), X_.end(), 0.0);
  std::fill(overlap_.begin(), overlap_.end(), 0.0);
}

void LowLayer::grow(int groups, const OperatingGrid& grid, const GridPlace& place) noexcept {
  const int count = static_cast<int>(deviation_.size());
  for (; groups_done_ < groups; ++groups_done_) {
    if (groups_done_ == 0) place_ = place;
    grid.mix(place_, &OperatingState::lo, groups_done_ * count, count, deviation_.data());
    tree_.produce(groups_done_, deviation_.data(), slice_.data());
    for (std::size_t i = 0; i < slice_.size(); ++i)
      X_[static_cast<std::size_t>(groups_done_) + i * kGroups] = slice_[i];
  }
}

}  // namespace rigsound::diesel
