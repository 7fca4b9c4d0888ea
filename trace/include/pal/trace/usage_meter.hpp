// When a processor has something to do: busy periods and loads (docs/reference/execution-model.md, "What is
// measured").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pal/trace/meter.hpp"

namespace pal::trace {

/// Follows one processor. A pause of no length is none.
class UsageMeter {
 public:
  UsageMeter(const Trace& tables, const std::string& processor);

  /// A busy period that is over, unless it goes on at this instant: then it comes once more, and longer.
  std::optional<Occurrence> see(const Event& event);
  /// The skill ends at `time_ns`, and with it the busy period.
  std::optional<Occurrence> finish(std::int64_t time_ns);

  /// Since when the processor has had something to do; nothing: it has nothing to do.
  std::optional<std::int64_t> busy_since() const {
    return runnable_ > 0 ? std::optional(since_) : std::nullopt;
  }
  /// For how long it had something to do until `time_ns`, which is no earlier than the last event.
  std::int64_t work(std::int64_t time_ns) const { return work_ + (runnable_ > 0 ? time_ns - from_ : 0); }
  /// Whether the thread runs there.
  bool has(std::int32_t actor) const { return own_[static_cast<std::size_t>(actor)]; }

 private:
  void set(std::int32_t actor, bool runs, std::int64_t time_ns);

  std::vector<bool> own_;   // by actor: it runs there
  std::vector<bool> runs_;  // by actor: it needs the processor, or has it
  int runnable_ = 0;
  std::int64_t since_ = -1;   // of the busy period, the last one if there is none
  std::int64_t from_ = 0;     // when it had something to do last, without a pause of any length
  std::int64_t paused_ = -1;  // when it had nothing to do any more; -1: never
  std::int64_t work_ = 0;     // before from_
};

}  // namespace pal::trace
