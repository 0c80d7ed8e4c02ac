#include "diesel/high_layer.hpp"

#include <algorithm>

namespace rigsound::diesel {

HighLayer::HighLayer(const DieselModel& model, double sample_rate, std::uint64_t seed)
    : ring_(1024), slot_(static_cast<std::size_t>(model.slot_samples())) {
  const bool clean = std::all_of(model.points.begin(), model.points.end(),
                                 [](const DieselPoint& p) { return !p.grains.empty(); });
  if (clean)
    grains_.emplace(model, seed);
  else
    slots_.emplace(model, sample_rate, seed);
}

void HighLayer::produce(std::int64_t end, const OperatingGrid& grid, const OperatingPoint& at) noexcept {
  while (ring_.end() < end) {
    if (grains_)
      grains_->produce(at.rpm, at.load, slot_.data());
    else
      slots_->produce(grid, at.place, cycles_per_second(at.rpm), slot_.data());
    ring_.push(slot_.data(), static_cast<int>(slot_.size()));
  }
}

void HighLayer::reset() noexcept {
  if (slots_) slots_->reset();
  ring_.clear();
}

}  // namespace rigsound::diesel
