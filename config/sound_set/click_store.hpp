// Where the samples of many banks lie end to end.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "rigsound/file/large_block.hpp"

namespace rigsound::config {

/// Thread: OFF.
class ClickStore {
 public:
  /// Memory is taken in blocks of `block_bytes`, or of what is asked for when that is more.
  explicit ClickStore(std::size_t block_bytes = 0) : block_bytes_(block_bytes) {}

  /// Zeros for `count` samples from a multiple of 64 bytes on; they outlive the store.
  std::shared_ptr<float> room(std::size_t count);

 private:
  std::size_t block_bytes_, used_ = 0;
  std::optional<LargeBlock> block_;
};

}  // namespace rigsound::config
