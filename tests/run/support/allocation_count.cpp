#include "tests/run/support/allocation_count.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<std::size_t> allocations = 0;
std::atomic<bool> counting = false;
}  // namespace

// In a file of its own: where they are inlined, g++ takes malloc and delete for a mismatched pair.
void* operator new(std::size_t size) {
  if (counting) ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (counting) ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace pal::test {

void count_allocations(bool on) {
  counting = on;
}
std::size_t counted_allocations() {
  return allocations;
}
void reset_allocations() {
  allocations = 0;
}

}  // namespace pal::test
