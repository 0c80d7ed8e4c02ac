#include "mix/lookahead_limiter.hpp"

#include <algorithm>

#include "rigsound/dsp/ramp.hpp"

namespace rigsound::mix {
namespace {

constexpr double kTargetShare = 1 - 0.008;  // of the ceiling
constexpr double kHold_s = 0.010;           // longer than half a period of 50 Hz: a low tone keeps its shape
constexpr double kRecovery_s = 0.12;
constexpr double kRecovered = 1e-6;  // this near to 1 it is 1

std::size_t hold_chunks(double sample_rate) {
  return static_cast<std::size_t>(kHold_s * sample_rate / kChunk) + 1;
}

/// The next place of a list that is written in turn.
template <class List>
std::size_t following(std::size_t place, const List& list) noexcept {
  return place + 1 == list.size() ? 0 : place + 1;
}

}  // namespace

// A point of the curve is chosen kLeastLookahead - 2 ... chunks - 1 chunks after the one it stands in, and
// each wish counts for the points from two before its chunk to one behind it.
LookaheadLimiter::LookaheadLimiter(double ceiling, int chunks, double sample_rate)
    : target_(kTargetShare * ceiling),
      release_(dsp::one_pole_remainder(kRecovery_s, kChunk, sample_rate)),
      chunks_(chunks),
      line_(static_cast<std::size_t>(chunks + 1)),
      sounds_(static_cast<std::size_t>(chunks + 1), 0),
      wishes_(static_cast<std::size_t>(chunks + 1) + hold_chunks(sample_rate), 1.0),
      held_(static_cast<std::size_t>(chunks - kLeastLookahead + 1), 1.0) {}

double LookaheadLimiter::wish(bool sounds) noexcept {
  dsp::Lanes* x = input();
  if (sounds_[static_cast<std::size_t>(before(newest_))] != 0) {
    std::copy_n(slot(before(newest_)) + kChunk, TruePeak::kPast, x - TruePeak::kPast);
    if (!sounds) std::fill_n(x, kChunk, dsp::Lanes{});  // a true peak may follow the last sample
  } else {
    if (!sounds) return 1;
    std::fill_n(x - TruePeak::kPast, TruePeak::kPast, dsp::Lanes{});
  }
  const double peak = peak_.of(x, target_);
  return peak > target_ ? target_ / peak : 1.0;
}

double LookaheadLimiter::lowest_wish() const noexcept {
  return wished_ == 0 ? 1.0 : *std::min_element(wishes_.begin(), wishes_.end());
}

void LookaheadLimiter::move_gain(double wish) noexcept {
  if (wish == 1 && wished_ == 0 && gain_.is_one()) return;  // all that is held is 1, wherever its turn is
  wishes_[next_wish_] = wish;
  next_wish_ = following(next_wish_, wishes_);
  wished_ = wish < 1 ? wishes_.size() : wished_ > 0 ? wished_ - 1 : 0;
  const double recovering = 1 - (1 - recovered_) * release_;
  recovered_ = std::min(lowest_wish(), recovering > 1 - kRecovered ? 1.0 : recovering);
  held_[next_held_] = recovered_;
  next_held_ = following(next_held_, held_);
  double sum = 0;
  for (const double gain : held_) sum += gain;
  before_ = here_, here_ = after_, after_ = sum / static_cast<double>(held_.size());
  gain_ = GainCurve::through(before_, here_, after_);
}

const dsp::Lanes* LookaheadLimiter::process(bool sounds) noexcept {
  move_gain(wish(sounds));
  sounds_[static_cast<std::size_t>(newest_)] = sounds ? 1 : 0;
  newest_ = newest_ == chunks_ ? 0 : newest_ + 1;
  return sounds_[static_cast<std::size_t>(newest_)] != 0 ? input() : nullptr;
}

}  // namespace rigsound::mix
