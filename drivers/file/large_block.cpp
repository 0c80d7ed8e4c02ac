#include "rigsound/file/large_block.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <new>

namespace rigsound {
namespace {

std::size_t rounded_up(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }

/// Small pages where they do, and for a rest that would leave most of a large one empty.
std::size_t paged(std::size_t bytes) {
  constexpr std::size_t kPiece = LargeBlock::kPiece;
  const std::size_t rest = bytes % kPiece;
  const bool large = bytes >= kPiece && rest > kPiece / 2;
  return bytes - rest +
         (large ? kPiece : rounded_up(rest, static_cast<std::size_t>(::sysconf(_SC_PAGESIZE))));
}

/// At a multiple of a piece; `bytes` is one of pages. Usable only when its pages are chosen: locked memory is
/// filled as soon as it can be.
char* mapped_pages(std::size_t bytes) {
  constexpr std::size_t kPiece = LargeBlock::kPiece;
  void* const room = ::mmap(nullptr, bytes + kPiece, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  const std::size_t before = -reinterpret_cast<std::uintptr_t>(room) % kPiece;
  char* const first = static_cast<char*>(room) + before;
  if (before > 0) ::munmap(room, before);
  if (before < kPiece) ::munmap(first + bytes, kPiece - before);
  ::madvise(first, bytes, MADV_HUGEPAGE);  // a kernel without large pages has small ones
  if (::mprotect(first, bytes, PROT_READ | PROT_WRITE) == 0) return first;
  ::munmap(first, bytes);
  throw std::bad_alloc();
}

}  // namespace

LargeBlock::LargeBlock(std::size_t bytes) : size_(bytes) {
  const std::size_t size = paged(bytes);
  if (size == 0) return;
  pieces_.reserve((size + kPiece - 1) / kPiece);
  char* const first = mapped_pages(size);
  for (std::size_t at = 0; at < size; at += kPiece) {
    const std::size_t piece = size - at < kPiece ? size - at : kPiece;
    pieces_.emplace_back(first + at, [piece](char* pages) { ::munmap(pages, piece); });
  }
}

std::shared_ptr<char> LargeBlock::part(std::size_t at, std::size_t count) const {
  const auto begin = pieces_.begin() + static_cast<std::ptrdiff_t>(at / kPiece),
             end = pieces_.begin() + static_cast<std::ptrdiff_t>((at + count - 1) / kPiece + 1);
  if (end - begin == 1) return {*begin, data() + at};
  return {std::make_shared<std::vector<std::shared_ptr<char>>>(begin, end), data() + at};
}

}  // namespace rigsound
