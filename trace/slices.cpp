#include "pal/trace/slices.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace pal::trace {

namespace {

/// Follows one trace, event by event, with at most one open slice for each actor.
class Follower {
 public:
  explicit Follower(const Trace& trace) : open_(trace.actors.size()) {}

  void follow(const Event& event) {
    now_ = event.time_ns;
    switch (event.kind) {
      case Kind::ready:
        close(event.actor, Ending::over);
        open(event, State::ready);
        break;
      case Kind::start:
        close(event.actor, Ending::over);
        open(event, State::running);
        break;
      case Kind::stop:
        close(event.actor, Ending::preempted);
        open(event, State::ready);
        break;
      case Kind::done:
        finish(event);
        break;
      case Kind::block:
        close(event.actor, Ending::blocked);
        open(event, State::waiting);
        break;
      case Kind::give_up:
        close(event.actor, Ending::gave_up);
        break;
      case Kind::cancel:
        close(event.actor, Ending::cancelled);
        break;
      case Kind::busy:
        close(event.actor, Ending::over);
        open(event, State::serving);
        break;
      case Kind::idle:
        close(event.actor, Ending::over);
        break;
      default:
        break;
    }
  }

  std::vector<Slice> finished(std::int64_t known_until_ns) {
    now_ = std::max(now_, known_until_ns);
    for (std::size_t actor = 0; actor < open_.size(); ++actor) {
      close(static_cast<std::int32_t>(actor), Ending::open);
    }
    std::stable_sort(closed_.begin(), closed_.end(),
                     [](const Slice& a, const Slice& b) { return a.from_ns < b.from_ns; });
    return std::move(closed_);
  }

 private:
  bool known(std::int32_t actor) const {
    return actor >= 0 && static_cast<std::size_t>(actor) < open_.size();
  }

  void open(const Event& event, State state) {
    if (!known(event.actor)) return;
    Slice slice{event.actor, state, Ending::open, event.statement, -1, now_, now_};
    if (state == State::waiting) slice.channel = event.subject;
    open_[static_cast<std::size_t>(event.actor)] = slice;
  }

  void close(std::int32_t actor, Ending ending) {
    if (!known(actor)) return;
    std::optional<Slice>& slice = open_[static_cast<std::size_t>(actor)];
    if (!slice) return;
    slice->to_ns = now_;
    const bool runs = slice->state == State::running;
    // What ends a wait or a readiness is that it is over, whatever comes next.
    const bool own =
        runs || ending == Ending::gave_up || ending == Ending::cancelled || ending == Ending::open;
    slice->ending = own ? ending : Ending::over;
    // Of what takes no time only effects count: they have happened.
    if (slice->to_ns > slice->from_ns || (runs && ending == Ending::effect)) {
      closed_.push_back(*slice);
    }
    slice.reset();
  }

  // An effect without a slice of its own: a statement that costs nothing, or a send whose slot became free.
  void finish(const Event& event) {
    if (!known(event.actor)) return;
    const std::optional<Slice>& slice = open_[static_cast<std::size_t>(event.actor)];
    if (!slice || slice->state != State::running) {
      close(event.actor, Ending::over);
      open(event, State::running);
    }
    close(event.actor, Ending::effect);
  }

  std::vector<std::optional<Slice>> open_;
  std::vector<Slice> closed_;
  std::int64_t now_ = 0;
};

}  // namespace

std::vector<Slice> slices(const Trace& trace, std::int64_t known_until_ns) {
  Follower follower(trace);
  for (const Event& event : trace.events) follower.follow(event);
  return follower.finished(known_until_ns);
}

}  // namespace pal::trace
