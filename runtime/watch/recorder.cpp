#include "runtime/watch/recorder.hpp"

#include <algorithm>
#include <utility>

#include "pal/runtime/trace_ring.hpp"

namespace pal::runtime {

Recorder::Recorder(const Wiring& wiring, TraceMode mode, std::size_t capacity, trace::EventSpool* spool)
    : mode_(mode),
      spool_(spool),
      capacity_(std::max<std::size_t>(capacity, 1)),
      trace_(trace_tables(wiring)) {
  if (mode != TraceMode::none) trace_.events.reserve(capacity_);
}

trace::Trace Recorder::take() {
  if (mode_ == TraceMode::all && spool_ != nullptr) hand_on();
  if (next_ != end_) std::rotate(trace_.events.data(), next_, end_);
  next_ = end_ = nullptr;
  return std::move(trace_);
}

}  // namespace pal::runtime
