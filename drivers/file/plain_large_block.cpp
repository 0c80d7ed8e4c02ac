// In place of large_block.cpp where memory has no pages: engine.wasm.
#include "rigsound/file/large_block.hpp"

namespace rigsound {

LargeBlock::LargeBlock(std::size_t bytes) : size_(bytes) {
  if (bytes > 0) pieces_.emplace_back(new char[bytes](), [](const char* all) { delete[] all; });
}

std::shared_ptr<char> LargeBlock::part(std::size_t at, std::size_t) const {
  return {pieces_.front(), data() + at};
}

}  // namespace rigsound
