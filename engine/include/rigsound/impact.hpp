// One blow of the hammer, as every layer of a boom hears it.
#pragma once

#include <cstdint>

namespace rigsound {

struct Impact {
  double onset = 0;         ///< samples after the chunk's first sample, 0 <= onset < kChunk, not rounded
  double amplitude = 1;     ///< relative to the mean blow (mean 1)
  std::uint64_t index = 0;  ///< counts the blows of this boom; seeds whatever varies from blow to blow
};

/// The impacts that start within one chunk, in order. Refers to the train that made them. Thread: RT.
struct Impacts {
  const Impact* first = nullptr;
  int count = 0;

  const Impact* begin() const noexcept { return first; }
  const Impact* end() const noexcept { return first + count; }
};

}  // namespace rigsound
