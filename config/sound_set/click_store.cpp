#include "sound_set/click_store.hpp"

#include <algorithm>

namespace rigsound::config {

std::shared_ptr<float> ClickStore::room(std::size_t count) {
  constexpr std::size_t kAligned = 64;
  if (count == 0) return nullptr;
  const std::size_t bytes = count * sizeof(float);
  if (!block_ || bytes > block_->size() - used_) block_.emplace(std::max(block_bytes_, bytes)), used_ = 0;
  const std::shared_ptr<char> part = block_->part(used_, bytes);
  used_ = std::min(block_->size(), (used_ + bytes + kAligned - 1) / kAligned * kAligned);
  return {part, reinterpret_cast<float*>(part.get())};
}

}  // namespace rigsound::config
