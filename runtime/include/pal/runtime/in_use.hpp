// Marks an object that only one run at a time may use.
#pragma once

#include <atomic>

namespace pal::runtime {

/// Belongs to a skill, a device, a world or a dispatcher. A copy of its owner is free.
class InUse {
 public:
  InUse() = default;
  InUse(const InUse&) {}
  InUse& operator=(const InUse&) { return *this; }

  /// False: it is in use already, by this thread or another one.
  bool take() { return !taken_.exchange(true); }
  void free() { taken_.store(false); }

 private:
  std::atomic<bool> taken_ = false;
};

}  // namespace pal::runtime
