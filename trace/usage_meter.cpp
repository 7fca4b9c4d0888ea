#include "pal/trace/usage_meter.hpp"

namespace pal::trace {

UsageMeter::UsageMeter(const Trace& tables, const std::string& processor) : runs_(tables.actors.size()) {
  for (const Actor& actor : tables.actors) own_.push_back(!actor.device && actor.processor == processor);
}

std::optional<Occurrence> UsageMeter::see(const Event& event) {
  if (event.actor < 0 || !has(event.actor)) return std::nullopt;
  const bool was_busy = runnable_ > 0;
  switch (event.kind) {
    case Kind::ready:
    case Kind::start:
    case Kind::stop:
      set(event.actor, true, event.time_ns);
      break;
    case Kind::block:
    case Kind::done:  // it goes on at this instant, or never
    case Kind::cancel:
      set(event.actor, false, event.time_ns);
      break;
    default:
      break;
  }
  return was_busy && runnable_ == 0 ? std::optional(Occurrence{since_, event.time_ns, -1, -1}) : std::nullopt;
}

void UsageMeter::set(std::int32_t actor, bool runs, std::int64_t time_ns) {
  const auto at = static_cast<std::size_t>(actor);
  if (runs_[at] == runs) return;
  runs_[at] = runs;
  runnable_ += runs ? 1 : -1;
  if (runs && runnable_ == 1) {
    if (paused_ != time_ns) since_ = time_ns;
    from_ = time_ns;
  } else if (!runs && runnable_ == 0) {
    work_ += time_ns - from_;
    paused_ = time_ns;
  }
}

std::optional<Occurrence> UsageMeter::finish(std::int64_t time_ns) {
  if (runnable_ == 0) return std::nullopt;
  work_ += time_ns - from_;
  runnable_ = 0;
  runs_.assign(runs_.size(), false);
  return Occurrence{since_, time_ns, -1, -1};
}

}  // namespace pal::trace
