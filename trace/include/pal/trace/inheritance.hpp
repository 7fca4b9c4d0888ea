// Which thread started which: the blocks of a CONCURRENT begin with the knowledge of their parent.
#pragma once

#include <cstdint>
#include <vector>

#include "pal/trace/trace.hpp"

namespace pal::trace {

/// Follows a trace event by event and tells when a block begins.
class Inheritance {
 public:
  /// `trace` outlives it.
  explicit Inheritance(const Trace& trace);

  /// The parent from which `event`'s actor inherits at this event, or -1. To be called with every event, in
  /// order.
  std::int32_t begins(const Event& event);

 private:
  void end_blocks_of(std::int32_t parent);

  const std::vector<Actor>& actors_;
  std::vector<std::vector<std::int32_t>> blocks_;  // that it begins, by actor
  std::vector<bool> alive_;                        // blocks, by actor
};

}  // namespace pal::trace
