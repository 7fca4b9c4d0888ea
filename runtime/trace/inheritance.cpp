#include "runtime/trace/inheritance.hpp"

namespace pal::trace {
namespace {

bool is_progress(Kind kind) {
  return kind == Kind::ready || kind == Kind::start || kind == Kind::done;
}

}  // namespace

Inheritance::Inheritance(const Trace& trace) {
  for (const Actor& actor : trace.actors) {
    const auto dot = actor.name.find('.');
    threads_.push_back({actor.name.substr(0, dot), !actor.device && dot != std::string::npos});
  }
}

/// Of those that have come to a CONCURRENT at this instant the last; of the block's own module, if there is
/// one: a module that is run by Execute has its blocks in another's thread.
std::int32_t Inheritance::parent_of(std::int32_t block, std::int64_t now) const {
  std::int32_t found = -1;
  bool own = false;
  for (std::size_t t = 0; t < threads_.size(); ++t) {
    const Thread& other = threads_[t];
    if (other.forked_at != now || static_cast<std::int32_t>(t) == block) continue;
    const bool same = other.module == threads_[static_cast<std::size_t>(block)].module;
    const bool better = found < 0 || (same && !own) ||
                        (same == own && other.forked > threads_[static_cast<std::size_t>(found)].forked);
    if (!better) continue;
    found = static_cast<std::int32_t>(t);
    own = same;
  }
  return found;
}

std::int32_t Inheritance::begins(const Event& event) {
  if (event.actor < 0) return -1;
  Thread& actor = threads_[static_cast<std::size_t>(event.actor)];
  if (event.kind == Kind::cancel) actor.alive = false;
  if (is_progress(event.kind)) {
    // A parent that goes on has no blocks left.
    for (Thread& other : threads_) {
      if (other.parent == event.actor) other.alive = false;
    }
  }
  std::int32_t parent = -1;
  if (event.kind != Kind::cancel && !actor.alive && actor.block) {
    parent = actor.parent = parent_of(event.actor, event.time_ns);
    actor.alive = true;
  }
  if (event.kind == Kind::block && event.subject < 0) {
    actor.forked_at = event.time_ns;
    actor.forked = ++forks_;
  }
  return parent;
}

}  // namespace pal::trace
