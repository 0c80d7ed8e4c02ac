// What the layers give the mixer.
#pragma once

#include "rigsound/machine/limits.hpp"

namespace rigsound::mix {

/// kChunk samples of one layer.
struct Bus {
  bool sounds = false;  ///< false: as good as zeros, whatever `x` holds
  alignas(64) double x[kChunk] = {};
};

/// kChunk samples of every layer.
struct Buses {
  Bus drill[kMaxBooms], tool[kMaxBooms];
  Bus diesel;
};

}  // namespace rigsound::mix
