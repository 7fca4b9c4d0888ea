// Which thread started which: the blocks of a CONCURRENT begin with what their parent had.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/trace/trace.hpp"

namespace pal::trace {

/// Follows a trace event by event and tells when a block begins.
class Inheritance {
 public:
  explicit Inheritance(const Trace& trace);

  /// The parent from which `event`'s actor inherits at this event, or -1. To be called with every event, in
  /// order.
  std::int32_t begins(const Event& event);

 private:
  std::vector<std::int32_t> parent_;  // by actor; -1: a module's own thread, or a device
  std::vector<bool> alive_;
};

}  // namespace pal::trace
