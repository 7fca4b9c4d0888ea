#include "runtime/trace/inheritance.hpp"

namespace pal::trace {
namespace {

bool is_progress(Kind kind) {
  return kind == Kind::ready || kind == Kind::start || kind == Kind::done;
}

}  // namespace

Inheritance::Inheritance(const Trace& trace) : actors_(trace.actors), alive_(trace.actors.size()) {}

void Inheritance::end_blocks_of(std::int32_t parent) {
  for (std::size_t block = 0; block < actors_.size(); ++block) {
    if (actors_[block].parent != parent || !alive_[block]) continue;
    alive_[block] = false;
    end_blocks_of(static_cast<std::int32_t>(block));
  }
}

std::int32_t Inheritance::begins(const Event& event) {
  if (event.actor < 0) return -1;
  const auto actor = static_cast<std::size_t>(event.actor);
  // A parent that goes on, or is stopped, has no blocks left.
  if (is_progress(event.kind) || event.kind == Kind::cancel) end_blocks_of(event.actor);
  if (event.kind == Kind::cancel) alive_[actor] = false;
  if (event.kind == Kind::cancel || alive_[actor]) return -1;
  alive_[actor] = true;
  return actors_[actor].parent;
}

}  // namespace pal::trace
