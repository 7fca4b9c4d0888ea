// Memory for coroutine frames: taken from the heap once, before the skill starts, and used again and again.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace pal::runtime {

/// Keeps the blocks that it is given back. Takes from the heap only when no free block is large enough.
class FramePool {
 public:
  FramePool() { blocks_.reserve(64); }
  FramePool(const FramePool&) = delete;
  FramePool& operator=(const FramePool&) = delete;

  /// Memory for `size` bytes with the alignment of new. Give it back by FramePool::release.
  void* allocate(std::size_t size);

  /// Gives back what allocate() of any pool that still lives returned.
  static void release(void* memory) noexcept;

 private:
  struct Block {
    std::unique_ptr<std::byte[]> bytes;
    std::size_t size = 0;
    bool free = false;
  };
  struct Header {
    FramePool* pool;
    std::size_t block;
  };
  static constexpr std::size_t header_size = alignof(std::max_align_t) > sizeof(Header)
                                                 ? alignof(std::max_align_t)
                                                 : sizeof(Header);
  std::vector<Block> blocks_;
};

}  // namespace pal::runtime
