#include "pal/check/deadlock/ways_on.hpp"

#include <algorithm>
#include <utility>

#include "pal/check/deadlock/dead.hpp"

namespace pal::check::deadlock {

namespace {

bool moves_thread(const State& before, const Move& move, std::size_t thread) {
  return move.action.thread == thread || before[thread] != move.state[thread];
}

}  // namespace

/// The run can be followed from here and moves the thread in the end.
bool WaysOn::follows(const State& from, std::size_t thread, const std::vector<Action>& run) const {
  State state = from;
  for (std::size_t i = 0; i < run.size(); ++i) {
    std::vector<Move> moves;
    moves_.of(state, run[i].thread, moves);
    const auto found =
        std::find_if(moves.begin(), moves.end(), [&](const Move& move) { return move.action == run[i]; });
    if (found == moves.end()) return false;
    if (i + 1 == run.size()) return moves_thread(state, *found, thread) || found->ended;
    if (found->ended) return false;
    if (moves_.blurred(found->state)) return false;
    state = found->state;
  }
  return false;
}

std::shared_ptr<const WaysOn::Way> WaysOn::described(const State& from, std::size_t thread,
                                                     std::vector<Action> run) const {
  Way way{std::move(run), {}, false};
  way.in_the_way.set(thread);
  State state = from;
  for (const auto& action : way.run) {
    std::vector<Move> moves;
    moves_.of(state, action.thread, moves);
    way.in_the_way.set(action.thread);
    way.in_the_way |= independence_.disturbing(state, action.thread, moves);
    for (auto& move : moves) {
      if (!(move.action == action)) continue;
      state = std::move(move.state);
      break;
    }
  }
  return std::make_shared<const Way>(std::move(way));
}

const WaysOn::Way& WaysOn::way(const State& state, std::size_t thread) {
  auto& known = ways_[state][thread];
  if (known != nullptr) return *known;
  Goal goal;
  goal.move = [&](const State& before, const Move& move) {
    return moves_thread(before, move, thread) || move.ended;
  };
  goal.needed = [&](const State&, const Enabled&) { return Threads().set(thread); };
  auto found = search(moves_, independence_, automata_.threads.size(), state, goal,
                      std::min(most_states_, left_), stop_);
  left_ -= std::min(left_, found.states);
  complete_ = complete_ && found.complete;
  std::vector<Action> run;
  if (found.way) run = std::move(found.way->run);
  // The search may have entered other states, and this one again.
  auto& entry = ways_[state][thread];
  entry = run.empty() ? std::make_shared<const Way>(Way{{}, {}, found.complete})
                      : described(state, thread, std::move(run));
  return *entry;
}

bool WaysOn::never_moves(const State& state, std::size_t thread) {
  return way(state, thread).missing;
}

bool WaysOn::dead(const State& state) {
  return deadlock::dead(automata_, moves_, state, 0,
                        [&](std::size_t thread) { return never_moves(state, thread); });
}

Threads WaysOn::in_the_way(const State& state) {
  Threads result;
  deadlock::dead(automata_, moves_, state, 0, [&](std::size_t thread) {
    const auto& found = way(state, thread);
    result |= found.in_the_way;
    return found.missing;
  });
  // Threads that can go on at once, and blocks of them, must move before they are anywhere to wait for ever.
  for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
    auto root = t;
    while (automata_.threads[root].parent) root = *automata_.threads[root].parent;
    if (root != 0 || !moves_.active(state, t)) continue;
    const auto kind = moves_.at(state, t).kind;
    if (kind != Step::Kind::wait && kind != Step::Kind::send && kind != Step::Kind::join) result.set(t);
  }
  return result;
}

void WaysOn::inherit(const State& before, const Move& move) {
  const auto from = ways_.find(before);
  if (from == ways_.end() || move.ended || ways_.find(move.state) != ways_.end()) return;
  ByThread inherited;
  for (const auto& [thread, way] : from->second) {
    if (way == nullptr || way->run.empty()) continue;
    auto run = way->run;
    if (run.front() == move.action) run.erase(run.begin());
    if (!run.empty() && follows(move.state, thread, run))
      inherited[thread] = described(move.state, thread, std::move(run));
  }
  ways_.emplace(move.state, std::move(inherited));
}

}  // namespace pal::check::deadlock
