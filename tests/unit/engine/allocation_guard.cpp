#include "engine/allocation_guard.hpp"

#include <cstdlib>
#include <new>

namespace {
thread_local long count = 0;

void* counted(std::size_t size) noexcept {
  ++count;
  return std::malloc(size ? size : 1);
}

void* or_throw(void* memory) { return memory ? memory : throw std::bad_alloc(); }
}  // namespace

namespace rigsound::tests {
long allocations() { return count; }
}  // namespace rigsound::tests

void* operator new(std::size_t size) { return or_throw(counted(size)); }
void* operator new[](std::size_t size) { return or_throw(counted(size)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++count;
  const auto to = static_cast<std::size_t>(alignment);
  return or_throw(std::aligned_alloc(to, (size + to - 1) / to * to));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
