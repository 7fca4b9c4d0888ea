#include "runtime/kernel/frame_pool.hpp"

#include <new>

namespace pal::runtime {

void* FramePool::allocate(std::size_t size) {
  std::size_t best = blocks_.size();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (!blocks_[i].free || blocks_[i].size < size) continue;
    if (best == blocks_.size() || blocks_[i].size < blocks_[best].size) best = i;
  }
  if (best == blocks_.size()) {
    blocks_.push_back({std::make_unique<std::byte[]>(header_size + size), size, false});
  }
  blocks_[best].free = false;
  std::byte* bytes = blocks_[best].bytes.get();
  new (bytes) Header{this, best};
  return bytes + header_size;
}

void FramePool::release(void* memory) noexcept {
  auto* header = reinterpret_cast<Header*>(static_cast<std::byte*>(memory) - header_size);
  header->pool->blocks_[header->block].free = true;
}

}  // namespace pal::runtime
