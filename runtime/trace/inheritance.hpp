// Which thread started which: the blocks of a CONCURRENT begin with what their parent had.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/trace/trace.hpp"

namespace pal::trace {

/// Follows a trace event by event and tells when a block begins. The blocks of a module are numbered through,
/// those of a block as well: the parent is whoever has just come to a CONCURRENT.
class Inheritance {
 public:
  explicit Inheritance(const Trace& trace);

  /// The parent from which `event`'s actor inherits at this event, or -1. To be called with every event, in
  /// order.
  std::int32_t begins(const Event& event);

 private:
  struct Thread {
    std::string module;  // of its name
    bool block = false;
    bool alive = false;
    std::int32_t parent = -1;     // while it is alive
    std::int64_t forked_at = -1;  // when it last came to a CONCURRENT
    std::int64_t forked = 0;      // before whom, at that instant
  };

  std::int32_t parent_of(std::int32_t block, std::int64_t now) const;

  std::vector<Thread> threads_;  // by actor
  std::int64_t forks_ = 0;
};

}  // namespace pal::trace
