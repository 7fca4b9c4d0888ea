#include "pal/check/deadlock/dead.hpp"

namespace pal::check::deadlock {

bool dead(const Automata& automata, const Moves& moves, const State& state, std::size_t thread,
          const std::function<bool(std::size_t)>& never_moves) {
  if (!moves.active(state, thread)) return false;
  const auto& step = moves.at(state, thread);
  if (step.kind == Step::Kind::wait || step.kind == Step::Kind::send) return never_moves(thread);
  if (step.kind != Step::Kind::join) return false;
  const bool ends = !step.next.empty();
  bool some = false;
  bool all = true;
  for (const auto block : automata.threads[thread].children) {
    if (!moves.active(state, block)) continue;
    if (ends && !automata.threads[block].can_end) continue;
    // Every block is asked, so that the caller learns of all that matter.
    const bool block_is = dead(automata, moves, state, block, never_moves);
    some = some || block_is;
    all = all && block_is;
  }
  return some && (ends || all);
}

}  // namespace pal::check::deadlock
