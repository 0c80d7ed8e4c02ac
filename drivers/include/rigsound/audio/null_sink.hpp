// A card that is not there: takes blocks at their pace and forgets them.
#pragma once

#include "rigsound/audio/clock.hpp"
#include "rigsound/audio/sink.hpp"

namespace rigsound::audio {

class NullSink : public Sink {
 public:
  NullSink(Clock& clock, double rate_hz, int block_frames) : pacer_(clock, rate_hz, block_frames) {}
  void write(const float*, std::uint64_t) noexcept override { pacer_.wait(); }

 private:
  Pacer pacer_;
};

}  // namespace rigsound::audio
