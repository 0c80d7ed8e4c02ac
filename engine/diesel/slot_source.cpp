#include "diesel/slot_source.hpp"

#include <algorithm>

namespace rigsound::diesel {
namespace {

constexpr double kHighest = 0.47;  // of the sampling rate; this is the whole anti-aliasing

}  // namespace

SlotSource::SlotSource(const DieselModel& model, double sample_rate, std::uint64_t seed)
    : L_(model.slots),
      M_(model.slot_samples()),
      sample_rate_(sample_rate),
      random_(seed, 41),
      bank_(M_),
      edges_(slot_band_edges(M_)),
      X_(static_cast<std::size_t>(M_)),
      overlap_(static_cast<std::size_t>(M_)) {
  bands_ = static_cast<int>(edges_.size()) - 1;
  deviation_.resize(static_cast<std::size_t>(bands_));
}

void SlotSource::produce(const OperatingGrid& grid, const GridPlace& place, double f, double* out) noexcept {
  // Frame t spans the hops t - 1 and t; the hop that comes out now began with the frame before this one.
  const int slot = static_cast<int>((frame_ + 1) % static_cast<std::uint64_t>(L_));
  grid.mix(place, &SlotStatistics::hi, slot * bands_, bands_, deviation_.data());
  double s = 0;
  grid.mix(place, &SlotStatistics::s, slot, 1, &s);
  const double rho = grid.rho(place);
  z_ = rho * z_ + std::sqrt(1 - rho * rho) * random_.normal(frame_, 0);
  const double gain = dsp::exp(0.5 * (s * z_ - 0.5 * s * s));

  const double channels = kHighest * sample_rate_ * 2 / (f * L_);  // one channel is f L / 2 Hz wide
  const int last = channels < M_ ? static_cast<int>(channels) : M_;
  std::fill(X_.begin(), X_.end(), 0.0);
  const std::uint64_t draw = frame_ * static_cast<std::uint64_t>(M_);
  for (int b = 0; b < bands_; ++b) {
    const double amplitude = gain * deviation_[static_cast<std::size_t>(b)];
    const int end = std::min(edges_[static_cast<std::size_t>(b + 1)], last);
    for (int q = edges_[static_cast<std::size_t>(b)]; q < end; ++q)
      X_[static_cast<std::size_t>(q)] = amplitude * random_.white(draw + static_cast<std::uint64_t>(q), 2);
  }
  bank_.synthesise(X_.data(), overlap_.data(), out);
  ++frame_;
}

void SlotSource::reset() noexcept {
  std::fill(overlap_.begin(), overlap_.end(), 0.0);
  z_ = 0;
}

}  // namespace rigsound::diesel
