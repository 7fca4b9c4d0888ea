// How threads get to their next steps: blocks that begin, end and are cancelled.
#include <algorithm>
#include <utility>

#include "pal/check/deadlock/moves.hpp"

namespace pal::check::deadlock {

/// The thread is done with its statement: it goes on, or stops if it was cancelled.
void Moves::go(Move move, std::size_t next, std::vector<Move>& result) const {
  const auto thread = move.action.thread;
  if (finishing(move.state, thread)) return stop(std::move(move), thread, result);
  arrive(std::move(move), thread, next, result);
}

void Moves::arrive(Move move, std::size_t thread, std::size_t step, std::vector<Move>& result) const {
  auto& state = move.state;
  for (std::size_t passed = 0; passed <= automata_.steps.size(); ++passed) {
    const auto& to = automata_.steps[step];
    state[thread] = word(step);
    if (to.kind == Step::Kind::enter) {
      step = to.next.front();
      continue;
    }
    if (to.kind == Step::Kind::end) {
      if (!automata_.threads[thread].parent) break;
      state[thread] = nowhere;
      for (std::size_t w = 0; w < 2 * bit_words_; ++w) state[latched(thread) + w] = 0;
      hand_over(state, thread, *automata_.threads[thread].parent);
      return after_blocks(std::move(move), *automata_.threads[thread].parent, result);
    }
    if (to.kind != Step::Kind::fork) break;
    // One that comes again without anything between goes round for ever: the thread spins there.
    if (++move.forks > forks_) break;
    state[thread] = word(to.next.back());
    // All blocks are there before the first of them goes on: one that is empty ends at once.
    for (const auto block : to.blocks) {
      state[block] = word(automata_.threads[block].first);
      for (std::size_t w = 0; w < 2 * bit_words_; ++w) state[latched(block) + w] = state[latched(thread) + w];
    }
    std::vector<Move> made{std::move(move)};
    for (const auto block : to.blocks) {
      std::vector<Move> more;
      for (auto& each : made) {
        if (each.state[block] == nowhere || finishing(each.state, block)) {
          more.push_back(std::move(each));
        } else {
          arrive(std::move(each), block, automata_.threads[block].first, more);
        }
      }
      made = std::move(more);
    }
    for (auto& each : made) result.push_back(std::move(each));
    return;
  }
  result.push_back(std::move(move));
}

/// A block of `parent` has ended or stopped.
void Moves::after_blocks(Move move, std::size_t parent, std::vector<Move>& result) const {
  const auto& join = at(move.state, parent);
  if (join.kind != Step::Kind::join) return result.push_back(std::move(move));
  bool some = false;
  bool going_on = false;
  bool some_can_end = false;
  for (const auto block : automata_.threads[parent].children) {
    if (!active(move.state, block)) continue;
    some = true;
    if (finishing(move.state, block)) continue;
    going_on = true;
    some_can_end = some_can_end || automata_.threads[block].can_end;
  }
  const bool cancelled = finishing(move.state, parent);
  if (!some) {
    if (cancelled) return stop(std::move(move), parent, result);
    if (join.next.empty()) return result.push_back(std::move(move));
    return arrive(std::move(move), parent, join.next.front(), result);
  }
  if (cancelled || (going_on && !some_can_end)) return cancel(std::move(move), parent, result);
  result.push_back(std::move(move));
}

/// A block that is cancelled may finish its statement. What it asks for or has asked for itself is withdrawn
/// at once, so that finishing such a statement is as good as stopping.
bool Moves::may_have_begun(const State& state, std::size_t thread) const {
  const auto& step = at(state, thread);
  const auto asked_here = [&](pan::ChannelId answer) {
    const auto& request = automata_.request_of[answer.index()];
    if (!request || automata_.from_device[answer.index()]) return false;
    return answers(state, answer, thread);
  };
  switch (step.kind) {
    case Step::Kind::set:
      return true;
    case Step::Kind::send: {
      const auto request = step.channels.front();
      const bool asks = automata_.answer_of[request.index()] && !automata_.to_device[request.index()];
      return !asks;
    }
    case Step::Kind::wait:
      return std::any_of(step.channels.begin(), step.channels.end(),
                         [&](pan::ChannelId c) { return can_take(state, c) && !asked_here(c); });
    default:
      return false;
  }
}

/// Every block of `parent` stops, or finishes what it may have begun.
void Moves::cancel(Move move, std::size_t parent, std::vector<Move>& result) const {
  const auto& blocks = automata_.threads[parent].children;
  for (const auto block : blocks) {
    if (!active(move.state, block) || finishing(move.state, block)) continue;
    const auto& step = at(move.state, block);
    move.cancels = true;
    Move begun = move;
    begun.state[block] |= finishing_flag;
    if (step.kind == Step::Kind::join) return cancel(std::move(begun), block, result);
    const bool begins = may_have_begun(move.state, block);
    // Stopping may let the parent go on, which ends the matter; otherwise the next block is cancelled.
    if (begins) cancel(std::move(begun), parent, result);
    return stop(std::move(move), block, result);
  }
  // All are cancelled already; a parent that is itself cancelled hands on to its siblings.
  if (finishing(move.state, parent)) {
    const auto& above = automata_.threads[parent].parent;
    if (above) return cancel(std::move(move), *above, result);
  }
  result.push_back(std::move(move));
}

void Moves::stop(Move move, std::size_t thread, std::vector<Move>& result) const {
  move.state[thread] = nowhere;
  for (std::size_t w = 0; w < 2 * bit_words_; ++w) move.state[latched(thread) + w] = 0;
  abandon(move.state, thread);
  after_blocks(std::move(move), *automata_.threads[thread].parent, result);
}

}  // namespace pal::check::deadlock
