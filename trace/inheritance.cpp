#include "pal/trace/inheritance.hpp"

namespace pal::trace {
namespace {

bool is_progress(Kind kind) {
  return kind == Kind::ready || kind == Kind::start || kind == Kind::done;
}

}  // namespace

Inheritance::Inheritance(const Trace& trace)
    : actors_(trace.actors), blocks_(trace.actors.size()), alive_(trace.actors.size()) {
  for (std::size_t block = 0; block < actors_.size(); ++block) {
    const std::int32_t parent = actors_[block].parent;
    if (parent >= 0) blocks_[static_cast<std::size_t>(parent)].push_back(static_cast<std::int32_t>(block));
  }
}

void Inheritance::end_blocks_of(std::int32_t parent) {
  for (const std::int32_t block : blocks_[static_cast<std::size_t>(parent)]) {
    const auto at = static_cast<std::size_t>(block);
    if (!alive_[at]) continue;
    alive_[at] = false;
    end_blocks_of(block);
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
