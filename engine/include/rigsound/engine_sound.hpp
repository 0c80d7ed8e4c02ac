// Which samples this engine makes, in one word.
#pragma once

namespace rigsound {

/// The first digits of the hash of tests/golden/golden.sha256: engines of the same word make the same samples
/// of the same states. `tests/golden/same_bits` holds it against that file, and writes both.
constexpr const char* kEngineSound = "fc1d634f";

}  // namespace rigsound
