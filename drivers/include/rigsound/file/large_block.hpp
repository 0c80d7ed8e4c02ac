// Memory in the largest pages the machine has, for what is so large that the first touch of each page counts.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace rigsound {

/// Bytes that begin as zeros, at an address that is a multiple of any page.
class LargeBlock {
 public:
  /// What is given back at once, 2 MiB: a large page of x86-64 and aarch64. A block below that has small
  /// pages.
  static constexpr std::size_t kPiece = std::size_t{1} << 21;

  /// Errors: std::bad_alloc. Thread: OFF.
  explicit LargeBlock(std::size_t bytes);

  char* data() const noexcept { return pieces_.empty() ? nullptr : pieces_.front().get(); }
  std::size_t size() const noexcept { return size_; }  ///< as asked for

  /// `count` bytes, one or more, from `at` on: while a copy of the pointer lives, the pieces they lie in
  /// stay, even without the block. Thread: OFF.
  std::shared_ptr<char> part(std::size_t at, std::size_t count) const;

 private:
  std::size_t size_;
  std::vector<std::shared_ptr<char>> pieces_;  ///< one behind the other, each given back with its last user
};

/// All of a regular file, read once: whoever writes over the file changes nothing here. Errors: InputError.
/// Thread: OFF.
LargeBlock read_block(const std::filesystem::path& file);

}  // namespace rigsound
