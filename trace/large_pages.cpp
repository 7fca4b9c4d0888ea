#include "pal/trace/large_pages.hpp"

#include <sys/mman.h>

#include <new>

namespace pal::trace {
namespace {

constexpr std::size_t large_page = std::size_t(2) << 20U;

bool is_large(std::size_t bytes) {
  return bytes > large_page;
}
/// Whole pages, so that no other data is on them.
std::size_t in_whole_pages(std::size_t bytes) {
  return (bytes + large_page - 1) / large_page * large_page;
}

}  // namespace

void* allocate_in_large_pages(std::size_t bytes) {
  if (!is_large(bytes)) return ::operator new(bytes);
  const std::size_t size = in_whole_pages(bytes);
  void* room = ::operator new(size, std::align_val_t(large_page));
  ::madvise(room, size, MADV_HUGEPAGE);  // without it the room is as good, and slower
  return room;
}

void release_large_pages(void* room, std::size_t bytes) noexcept {
  if (!is_large(bytes)) {
    ::operator delete(room, bytes);
  } else {
    ::operator delete(room, in_whole_pages(bytes), std::align_val_t(large_page));
  }
}

}  // namespace pal::trace
