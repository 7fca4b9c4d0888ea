#include "pal/check/deadlock/decide.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "pal/check/deadlock/dead.hpp"
#include "pal/check/deadlock/search.hpp"
#include "pal/check/deadlock/thread_sets.hpp"

namespace pal::check::deadlock {

namespace {

constexpr std::uint32_t none = 0xffffffff;

/// There may be as many as a search may have states. Sets of threads are those of Decider::sets_, by number.
struct Node {
  const State* state = nullptr;
  std::uint32_t index = none;    // in the order of the search; none: not begun
  std::uint32_t lowlink = none;  // … the first of its component that is known
  std::uint32_t component = none;
  std::uint32_t chosen = 0;    // whose moves from here are followed
  std::uint32_t followed = 0;  // … and on the way to the states that are kept after it
  std::uint32_t moved = 0;     // some run from here moves them
  bool leaves = false;         // to another component
};

struct Successor {
  std::uint32_t to = 0;
  std::uint32_t moved = 0;
};

/// Moves that follow one another without an alternative.
struct Chain {
  std::uint32_t to = none;
  std::uint32_t followed = 0;
  std::uint32_t moved = 0;
  bool ended = false;
};

struct Frame {
  std::uint32_t node = 0;
  std::vector<Successor> successors;
  std::size_t next = 0;
};

/// Depth first, with Tarjan's strong components. What is left out must not be left out for ever. So of a
/// component that no run leaves, every move is followed somewhere (Valmari). Ways and components are those of
/// moves that are not guessed. Every state that a blurred one stands for has these moves, so a thread that
/// they move can move.
class Decider {
 public:
  Decider(const Automata& automata, const Moves& moves, const Independence& independence, std::size_t most,
          const std::function<bool()>& stop)
      : automata_(automata), moves_(moves), independence_(independence), most_(most), stop_(stop) {
    const auto channels = automata.request_of.size();
    result_.put.resize(channels);
    result_.taken.resize(channels);
    result_.undelivered.resize(channels);
  }

  Decision run() {
    begin(node_of(moves_.first()));
    while (result_.complete && (!frames_.empty() || begin_guessed())) {
      auto& frame = frames_.back();
      if (frame.next < frame.successors.size()) {
        follow(frame.node, frame.successors[frame.next++]);
      } else {
        leave();
      }
      if (nodes_.size() > most_ || moves_.overflowed() || (stop_ && stop_())) result_.complete = false;
    }
    result_.states = nodes_.size();
    return std::move(result_);
  }

 private:
  /// What guessed moves lead to is looked at by itself: that a run gets there, and on from there, cannot be
  /// relied on.
  bool begin_guessed() {
    while (!guessed_.empty()) {
      const auto id = guessed_.back();
      guessed_.pop_back();
      if (nodes_[id].index != none) continue;
      begin(id);
      return true;
    }
    return false;
  }

  std::uint32_t node_of(State state) {
    const auto [entry, fresh] = seen_.emplace(std::move(state), static_cast<std::uint32_t>(nodes_.size()));
    if (fresh) {
      nodes_.emplace_back();
      nodes_.back().state = &entry->first;
    }
    return entry->second;
  }

  void begin(std::uint32_t id) {
    {
      auto& node = nodes_[id];
      node.index = node.lowlink = count_++;
    }
    stack_.push_back(id);
    const State& state = *nodes_[id].state;
    const Enabled enabled(moves_, state, automata_.threads.size());
    const auto chosen = choose(independence_, state, enabled, {});
    if (chosen.none()) result_.total = true;
    frames_.push_back({id, {}, 0});
    add_successors(chosen, enabled);
  }

  void add(std::uint32_t& set, const Threads& more) { set = sets_.with(set, more); }
  void add(std::uint32_t& set, std::uint32_t more) { add(set, Threads(sets_[more])); }

  /// To the frame on top.
  void add_successors(const Threads& chosen, const Enabled& enabled) {
    const auto id = frames_.back().node;
    add(nodes_[id].chosen, chosen);
    for (std::size_t t = 0; t < enabled.size(); ++t) {
      if (!chosen.test(t)) continue;
      for (const auto& move : enabled[t]) add_successor(id, move);
      add(nodes_[id].moved, moved_by_guess(*nodes_[id].state, enabled[t]));
    }
  }

  /// Whatever is real of the thread's guessed moves moves these.
  Threads moved_by_guess(const State& state, const std::vector<Move>& moves) const {
    std::optional<Threads> result;
    for (const auto& move : moves) {
      if (!move.guessed) continue;
      Threads moved;
      add_moved(state, move, moved);
      if (move.ended) moved.set();
      result = result ? *result & moved : moved;
    }
    return result.value_or(Threads());
  }

  void add_successor(std::uint32_t from, const Move& move) {
    note(*nodes_[from].state, move);
    add(nodes_[from].followed, Threads().set(move.action.thread));
    if (move.guessed) {
      result_.blurred = result_.blurred || move.action.kind == Action::Kind::discards;
      if (!move.ended) guessed_.push_back(node_of(move.state));
      return;
    }
    if (move.ended) {
      nodes_[from].leaves = true;
      add(nodes_[from].moved, Threads().set());
      return;
    }
    const auto& chain = chain_from(move.state, move.action.thread);
    add(nodes_[from].followed, chain.followed);
    if (chain.ended) {
      nodes_[from].leaves = true;
      add(nodes_[from].moved, Threads().set());
      return;
    }
    Threads moved = sets_[chain.moved];
    add_moved(*nodes_[from].state, move, moved);
    frames_.back().successors.push_back({chain.to, sets_.number_of(moved)});
  }

  /// Follows what comes next without an alternative: the states in between are not kept.
  const Chain& chain_from(const State& first, std::size_t thread) {
    constexpr std::size_t most_at_once = 100;
    const auto [entry, fresh] = chains_.emplace(first, Chain());
    auto& chain = entry->second;
    if (!fresh) return chain;
    State state = first;
    Threads followed, moved;
    for (std::size_t i = 0; i < most_at_once; ++i) {
      const Enabled enabled(moves_, state, automata_.threads.size());
      const auto chosen = choose(independence_, state, enabled, {}, thread);
      if (chosen.count() != 1) break;
      for (thread = 0; !chosen.test(thread);) ++thread;
      if (enabled[thread].size() != 1) break;
      const auto& move = enabled[thread].front();
      note(state, move);
      followed.set(thread);
      add_moved(state, move, moved);
      chain.ended = move.ended;
      if (chain.ended) break;
      state = State(move.state);
    }
    chain.followed = sets_.number_of(followed);
    chain.moved = sets_.number_of(moved);
    if (!chain.ended) chain.to = node_of(std::move(state));
    return chain;
  }

  void add_moved(const State& before, const Move& move, Threads& moved) const {
    moved.set(move.action.thread);
    for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
      if (before[t] != move.state[t]) moved.set(t);
    }
  }

  void note(const State& state, const Move& move) {
    const auto channel = move.action.channel;
    if (move.action.kind == Action::Kind::sends) result_.put[channel.index()] = true;
    if (move.action.kind == Action::Kind::takes) result_.taken[channel.index()] = true;
    if (move.action.kind != Action::Kind::completes) return;
    for (std::size_t c = 0; c < automata_.command.size(); ++c) {
      if (automata_.command[c] && moves_.full(state, pan::ChannelId(c))) result_.undelivered[c] = true;
    }
  }

  void follow(std::uint32_t from, const Successor& successor) {
    add(nodes_[from].moved, successor.moved);
    const auto to = successor.to;
    if (nodes_[to].index == none) return begin(to);
    join(from, to);
  }

  /// After `to` is known: its component is complete, or it is one with that of `from`.
  void join(std::uint32_t from, std::uint32_t to) {
    add(nodes_[from].moved, nodes_[to].moved);
    if (nodes_[to].component != none) {
      nodes_[from].leaves = true;
    } else {
      nodes_[from].lowlink = std::min(nodes_[from].lowlink, nodes_[to].lowlink);
      nodes_[from].leaves = nodes_[from].leaves || nodes_[to].leaves;
    }
  }

  /// The frame on top has no more to follow.
  void leave() {
    const auto id = frames_.back().node;
    if (nodes_[id].lowlink == nodes_[id].index) {
      if (!nodes_[id].leaves && extend(id)) return;
      complete_component(id);
    }
    frames_.pop_back();
    if (!frames_.empty() && frames_.back().node != id) join(frames_.back().node, id);
  }

  /// A component that no run leaves: follows what it has left out, if there is something.
  bool extend(std::uint32_t root) {
    const auto begin_of = first_of(root);
    Threads followed;
    for (auto i = begin_of; i < stack_.size(); ++i) followed |= sets_[nodes_[stack_[i]].followed];
    for (auto i = begin_of; i < stack_.size(); ++i) {
      const auto id = stack_[i];
      const Enabled enabled(moves_, *nodes_[id].state, automata_.threads.size());
      if ((enabled.can_move() & ~followed).none()) continue;
      frames_.push_back({id, {}, 0});
      add_successors(enabled.can_move() & ~sets_[nodes_[id].chosen], enabled);
      return true;
    }
    return false;
  }

  /// Where the component begins on the stack.
  std::size_t first_of(std::uint32_t root) const {
    auto at = stack_.size();
    while (at > 0 && nodes_[stack_[at - 1]].index >= nodes_[root].index) --at;
    return at;
  }

  void complete_component(std::uint32_t root) {
    const auto begin_of = first_of(root);
    Threads moved;
    for (auto i = begin_of; i < stack_.size(); ++i) moved |= sets_[nodes_[stack_[i]].moved];
    const auto number = sets_.number_of(moved);
    for (auto i = begin_of; i < stack_.size(); ++i) {
      auto& node = nodes_[stack_[i]];
      node.component = root;
      node.moved = number;
      const auto never_moves = [&](std::size_t thread) { return !moved.test(thread); };
      result_.partial = result_.partial || dead(automata_, moves_, *node.state, 0, never_moves);
    }
    stack_.resize(begin_of);
  }

  const Automata& automata_;
  const Moves& moves_;
  const Independence& independence_;
  std::size_t most_;
  const std::function<bool()>& stop_;
  std::unordered_map<State, std::uint32_t> seen_;
  std::unordered_map<State, Chain> chains_;  // by the state that they begin in
  ThreadSets sets_;
  std::vector<Node> nodes_;
  std::vector<Frame> frames_;
  std::vector<std::uint32_t> guessed_;
  std::vector<std::uint32_t> stack_;
  std::uint32_t count_ = 0;
  Decision result_;
};

}  // namespace

Decision decide(const Automata& automata, const Moves& moves, const Independence& independence,
                std::size_t most_states, const std::function<bool()>& stop) {
  return Decider(automata, moves, independence, most_states, stop).run();
}

}  // namespace pal::check::deadlock
