// A part of a rendered sound: what comes before it is computed and dropped, so its samples are those of the
// whole.
#pragma once

#include <cmath>

#include "rigsound/audio/block_loop.hpp"

namespace rigsound::audio {

/// Blocks first...last - 1, counted from 0.
struct BlockRange {
  std::uint64_t first = 0, last = UINT64_MAX;
};

/// Whole blocks that hold from_s...to_s. Thread: any.
inline BlockRange blocks_of(double from_s, double to_s, const EngineOptions& options) {
  const double a_second = options.sample_rate / options.block;
  const double last = std::ceil(to_s * a_second - 1e-9);
  return {static_cast<std::uint64_t>(from_s * a_second + 1e-9),
          last < 1e18 ? static_cast<std::uint64_t>(last) : UINT64_MAX};
}

/// Ends a source before block `last`. Thread: OFF.
class EndingStates : public StateSource {
 public:
  EndingStates(StateSource& states, std::uint64_t last) : states_(states), last_(last) {}
  const MachineState* state_of(std::uint64_t number) override {
    return number < last_ ? states_.state_of(number) : nullptr;
  }
  std::uint64_t skipped_before(std::uint64_t number) override { return states_.skipped_before(number); }

 private:
  StateSource& states_;
  std::uint64_t last_;
};

/// Passes block `first` on as the first one. Thread: OFF.
class LateSink : public Sink {
 public:
  LateSink(Sink& sink, std::uint64_t first) : sink_(sink), first_(first) {}
  void write(const float* block, std::uint64_t number) override {
    if (number < first_) return;
    begun_ = true;
    sink_.write(block, number - first_);
  }
  void skip(std::uint64_t blocks) override {
    if (begun_) sink_.skip(blocks);
  }

 private:
  Sink& sink_;
  std::uint64_t first_;
  bool begun_ = false;
};

}  // namespace rigsound::audio
