#include "pal/check/deadlock/search.hpp"

#include <algorithm>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace pal::check::deadlock {

namespace {

constexpr std::uint32_t no_node = 0xffffffff;

/// States that are looked at, whatever the time: what is found at its end can still be told.
constexpr std::size_t at_least = 16;

struct SearchNode {
  const State* state = nullptr;  // none: the goal
  std::uint32_t from = no_node;
  Length length;
  Action action;
  bool done = false;
};

class Searcher {
 public:
  Searcher(const Moves& moves, const Independence& independence, std::size_t threads, const Goal& goal,
           std::size_t most, const std::function<bool()>& stop)
      : moves_(moves),
        independence_(independence),
        threads_(threads),
        goal_(goal),
        most_(most),
        stop_(stop) {}

  Found run(const State& from) {
    auto found = found_from(from);
    found.states = nodes_.size();
    return found;
  }

 private:
  Found found_from(const State& from) {
    reach(from, no_node, {}, {});
    while (!open_.empty()) {
      const auto at = std::get<1>(open_.top());
      open_.pop();
      if (nodes_[at].done) continue;
      nodes_[at].done = true;
      if (nodes_[at].state == nullptr) return {way_to(at, goal_state_)};
      if (nodes_.size() > most_ || stopped()) return {std::nullopt, false};
      const Enabled enabled(moves_, *nodes_[at].state, threads_);
      if (goal_.state && goal_.state(*nodes_[at].state, enabled)) return {way_to(at, *nodes_[at].state)};
      expand(at, enabled);
    }
    return {std::nullopt, complete_};
  }

  bool stopped() const { return stop_ && nodes_.size() > at_least && stop_(); }

  void reach(const State& state, std::uint32_t from, const Length& length, const Action& action) {
    const auto [entry, fresh] = seen_.emplace(state, static_cast<std::uint32_t>(nodes_.size()));
    if (fresh) {
      nodes_.push_back({&entry->first, from, length, action, false});
    } else {
      auto& node = nodes_[entry->second];
      if (node.done || node.length <= length) return;
      node.from = from;
      node.length = length;
      node.action = action;
    }
    open_.emplace(length, entry->second);
  }

  void reach_goal(const State& state, std::uint32_t from, const Length& length, const Action& action) {
    if (goal_node_ != no_node && nodes_[goal_node_].length <= length) return;
    goal_node_ = static_cast<std::uint32_t>(nodes_.size());
    goal_state_ = state;
    nodes_.push_back({nullptr, from, length, action, false});
    open_.emplace(length, goal_node_);
  }

  void expand(std::uint32_t at, const Enabled& enabled) {
    const State& state = *nodes_[at].state;
    const auto needed = goal_.needed ? goal_.needed(state, enabled) : Threads();
    if (goal_.needed && needed.none()) return;
    const auto chosen = choose(independence_, state, enabled, needed);
    for (std::size_t t = 0; t < threads_; ++t) {
      if (!chosen.test(t)) continue;
      for (const auto& move : enabled[t]) {
        const auto length = nodes_[at].length.after(move);
        if (goal_.move && goal_.move(state, move)) {
          reach_goal(move.state, at, length, move.action);
        } else if (moves_.blurred(move.state)) {
          complete_ = false;
        } else if (!move.ended) {
          reach(move.state, at, length, move.action);
        }
      }
    }
  }

  Way way_to(std::uint32_t at, const State& state) const {
    Way way{{}, state, nodes_[at].length};
    for (; nodes_[at].from != no_node; at = nodes_[at].from) way.run.push_back(nodes_[at].action);
    std::reverse(way.run.begin(), way.run.end());
    return way;
  }

  const Moves& moves_;
  const Independence& independence_;
  std::size_t threads_;
  const Goal& goal_;
  std::size_t most_;
  const std::function<bool()>& stop_;
  std::unordered_map<State, std::uint32_t> seen_;
  std::vector<SearchNode> nodes_;
  using Entry = std::tuple<Length, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::uint32_t goal_node_ = no_node;
  State goal_state_;
  bool complete_ = true;
};

}  // namespace

Threads choose(const Independence& independence, const State& state, const Enabled& enabled,
               const Threads& needed, std::size_t first) {
  const auto movable = [&](const Threads& some) {
    Threads result;
    for (std::size_t t = 0; t < enabled.size(); ++t) {
      if (some.test(t) && !enabled[t].empty()) result.set(t);
    }
    return result;
  };
  if (needed.any()) {
    const auto some = independence.closure(state, enabled, needed);
    return some ? movable(*some) : enabled.can_move();
  }
  // Those that wait for an event of a device come last: there is always a next one.
  const auto is_driven = [&](std::size_t t) {
    const auto& action = enabled[t].front().action;
    return action.kind == Action::Kind::takes && independence.from_device(action.channel);
  };
  std::optional<Threads> best;
  for (const bool driven : {false, true}) {
    for (std::size_t i = 0; i < enabled.size(); ++i) {
      const auto t = (first + i) % enabled.size();
      if (enabled[t].empty() || is_driven(t) != driven) continue;
      const auto closure = independence.closure(state, enabled, Threads().set(t));
      if (!closure) continue;
      const auto some = movable(*closure);
      if (some.count() == 1 && enabled[t].size() == 1) return some;
      if (!best || some.count() < best->count()) best = some;
    }
    if (best && best->count() == 1) return *best;
  }
  return best ? *best : enabled.can_move();
}

Found search(const Moves& moves, const Independence& independence, std::size_t threads, const State& from,
             const Goal& goal, std::size_t most_states, const std::function<bool()>& stop) {
  return Searcher(moves, independence, threads, goal, most_states, stop).run(from);
}

}  // namespace pal::check::deadlock
