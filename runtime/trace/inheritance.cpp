#include "runtime/trace/inheritance.hpp"

#include <algorithm>

namespace pal::trace {
namespace {

/// Block "SM1.2" belongs to "SM1", the thread whose name is the longest proper prefix that ends before a dot;
/// a nested block too, since its true parent is the thread of its module or a block named like one.
std::int32_t parent_of(const Trace& trace, const Actor& block) {
  const auto dot = block.name.rfind('.');
  if (block.device || dot == std::string::npos) return -1;
  const std::string prefix = block.name.substr(0, dot);
  const auto found = std::find_if(trace.actors.begin(), trace.actors.end(),
                                  [&](const Actor& actor) { return !actor.device && actor.name == prefix; });
  return found == trace.actors.end() ? -1 : static_cast<std::int32_t>(found - trace.actors.begin());
}

bool is_progress(Kind kind) {
  return kind == Kind::ready || kind == Kind::start || kind == Kind::done;
}

}  // namespace

Inheritance::Inheritance(const Trace& trace) : alive_(trace.actors.size(), false) {
  for (const Actor& actor : trace.actors) parent_.push_back(parent_of(trace, actor));
}

std::int32_t Inheritance::begins(const Event& event) {
  if (event.actor < 0) return -1;
  const auto actor = static_cast<std::size_t>(event.actor);
  if (event.kind == Kind::cancel) alive_[actor] = false;
  if (is_progress(event.kind)) {
    // A parent that goes on has no blocks left.
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      if (parent_[i] == event.actor) alive_[i] = false;
    }
  }
  if (event.kind == Kind::cancel || alive_[actor] || parent_[actor] < 0) return -1;
  alive_[actor] = true;
  return parent_[actor];
}

}  // namespace pal::trace
