// Memory of long lists, in large pages where the system has them.
#pragma once

#include <cstddef>

namespace pal::trace {

/// Room for `bytes`. Throws std::bad_alloc.
///
/// A system that hands out memory in pages of 4 KiB clears each of them when it is touched first. That may
/// take several times as long as writing the events of a run into it. Room of more than 2 MiB is therefore
/// aligned to 2 MiB, and the system is asked for pages of that size (`madvise`, MADV_HUGEPAGE). It may
/// decline.
void* allocate_in_large_pages(std::size_t bytes);
/// `bytes`: as it was allocated.
void release_large_pages(void* room, std::size_t bytes) noexcept;

/// An allocator for std::vector.
template <class Value>
struct LargePages {
  using value_type = Value;

  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other>&) {}  // as containers expect it

  Value* allocate(std::size_t count) {
    return static_cast<Value*>(allocate_in_large_pages(count * sizeof(Value)));
  }
  void deallocate(Value* room, std::size_t count) noexcept {
    release_large_pages(room, count * sizeof(Value));
  }
  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

}  // namespace pal::trace
