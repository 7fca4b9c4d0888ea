#include "runtime/watch/recorder.hpp"

#include <algorithm>
#include <utility>

#include "pal/runtime/trace_ring.hpp"

namespace pal::runtime {

namespace {
constexpr std::size_t at_a_time = 4096;  // so many places are made ready together
}

Recorder::Recorder(const Wiring& wiring, TraceMode mode, std::size_t capacity, trace::EventSpool* spool)
    : mode_(mode),
      spool_(mode == TraceMode::all ? spool : nullptr),
      capacity_(std::max<std::size_t>(capacity, 1)),
      trace_(trace_tables(wiring)) {
  if (mode != TraceMode::none) trace_.events.reserve(capacity_);
}

void Recorder::make_room() {
  if (mode_ == TraceMode::none) {
    next_ = &unkept_;
    end_ = next_ + 1;
    return;
  }
  trace::Events& events = trace_.events;
  const bool limited = mode_ == TraceMode::last || spool_ != nullptr;
  const std::size_t size = events.size();
  if (limited && size == capacity_) {
    if (spool_ != nullptr) spool_->append(events.data(), size);
    has_all_ = spool_ == nullptr;
    next_ = events.data();
  } else {
    events.resize(size + (limited ? std::min(at_a_time, capacity_ - size) : at_a_time));
    next_ = events.data() + size;
  }
  end_ = events.data() + events.size();
}

trace::Trace Recorder::take() {
  trace::Events& events = trace_.events;
  const auto written = events.empty() ? 0 : next_ - events.data();
  if (has_all_) {
    std::rotate(events.begin(), events.begin() + written, events.end());
  } else {
    events.resize(static_cast<std::size_t>(written));
  }
  if (spool_ != nullptr) {
    spool_->append(events.data(), events.size());
    events.clear();
  }
  next_ = end_ = nullptr;
  return std::move(trace_);
}

}  // namespace pal::runtime
