// Where blocks of sound go: a card, a file, nowhere.
#pragma once

#include <cstdint>

namespace rigsound::audio {

/// Every front end hands its blocks to one of these; the sink sets the pace.
class Sink {
 public:
  virtual ~Sink() = default;

  /// Takes one block of interleaved samples and returns when there is room for the next. `number`
  /// counts the blocks since the engine was built or reset, from 0. Live sinks never throw and have no
  /// errors (Thread: RT); file sinks throw DeviceError (Thread: OFF).
  virtual void write(const float* block, std::uint64_t number) = 0;

  /// So many blocks of silence, which do not count. Where time itself makes the silence: nothing.
  virtual void skip(std::uint64_t /*blocks*/) {}
};

}  // namespace rigsound::audio
