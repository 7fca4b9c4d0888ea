#include "pal/check/deadlock/explore.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "pal/check/deadlock/reduction.hpp"

namespace pal::frontend::deadlock {

namespace {

constexpr std::uint32_t none = 0xffffffff;
constexpr std::size_t most_steps = 0x7ff0;
constexpr std::size_t most_told = 64;  // threads of which it is known whether they ever go on

struct Node {
  const State* state = nullptr;
  std::uint32_t from = none;
  std::uint32_t timely = 0;
  std::uint32_t length = 0;
  Deed deed;
  bool expanded = false;
  bool ended = false;
  bool terminal = false;
};

struct Edge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint64_t moved = 0;
  Deed deed;
  bool timely = false;
};

class Explorer {
 public:
  Explorer(const Automata& automata, const Limits& limits, bool reduced)
      : automata_(automata),
        limits_(limits),
        reduced_(reduced),
        moves_(automata),
        reduction_(automata, moves_) {}

  Findings run() {
    if (automata_.threads.empty()) return {};
    if (automata_.steps.size() > most_steps) return {false, 0, {}, {}, {}};
    put_.resize(automata_.request_of.size());
    taken_.resize(automata_.request_of.size());
    reach(moves_.first(), none, {}, false, false);
    const auto most = std::min(limits_.states, limits_.words / moves_.words() + 1);
    while (!open_.empty()) {
      const auto at = std::get<2>(open_.top());
      open_.pop();
      if (nodes_[at].expanded || nodes_[at].ended) continue;
      if (nodes_.size() > most) {
        result_.complete = false;
        break;
      }
      expand(at);
    }
    result_.complete = result_.complete && !moves_.overflowed();
    result_.states = nodes_.size();
    conclude();
    return std::move(result_);
  }

 private:
  std::pair<std::uint32_t, bool> reach(State state, std::uint32_t from, const Deed& deed, bool timely,
                                       bool ended) {
    const auto [entry, fresh] = seen_.emplace(std::move(state), static_cast<std::uint32_t>(nodes_.size()));
    const auto id = entry->second;
    const std::uint32_t times = (from == none ? 0 : nodes_[from].timely) + (timely ? 1 : 0);
    const std::uint32_t length = from == none ? 0 : nodes_[from].length + 1;
    if (fresh) nodes_.push_back({&entry->first, from, times, length, deed, false, ended, false});
    auto& node = nodes_[id];
    if (!fresh && !node.expanded && std::tie(times, length) < std::tie(node.timely, node.length)) {
      node.from = from;
      node.timely = times;
      node.length = length;
      node.deed = deed;
    } else if (!fresh) {
      return {id, false};
    }
    open_.emplace(node.timely, node.length, id);
    return {id, fresh};
  }

  void expand(std::uint32_t at) {
    nodes_[at].expanded = true;
    const State& state = *nodes_[at].state;
    Reduction::Enabled enabled(automata_.threads.size());
    std::vector<std::size_t> all;
    for (std::size_t t = 0; t < enabled.size(); ++t) {
      moves_.of(state, t, enabled[t]);
      if (!enabled[t].empty()) all.push_back(t);
    }
    if (all.empty()) nodes_[at].terminal = true;
    const auto chosen = reduced_ ? reduction_.choose(state, enabled) : all;
    // What is left out must not be left out for ever: some move leads to what was not seen before, or all are
    // followed.
    bool fresh = false;
    for (const auto t : chosen) fresh = follow(at, enabled[t]) || fresh;
    if (fresh || chosen.size() == all.size()) return;
    for (const auto t : all) {
      if (std::find(chosen.begin(), chosen.end(), t) == chosen.end()) follow(at, enabled[t]);
    }
  }

  bool follow(std::uint32_t at, std::vector<Move>& moves) {
    bool fresh = false;
    for (auto& move : moves) {
      const State& state = *nodes_[at].state;
      std::uint64_t moved = move.deed.thread < most_told ? std::uint64_t{1} << move.deed.thread : 0;
      for (std::size_t t = 0; t < std::min(most_told, automata_.threads.size()); ++t) {
        if (state[t] != move.state[t]) moved |= std::uint64_t{1} << t;
      }
      if (move.ended) {
        // What became of the others does not matter any more.
        move.state.assign(move.state.size(), u'\xffff');
        moved = ~std::uint64_t{0};
      }
      if (move.deed.kind == Deed::Kind::sends) put_[move.deed.channel.index()] = true;
      if (move.deed.kind == Deed::Kind::takes) taken_[move.deed.channel.index()] = true;
      const auto [to, is_new] = reach(std::move(move.state), at, move.deed, move.timely, move.ended);
      edges_.push_back({at, to, moved, move.deed, move.timely});
      fresh = fresh || is_new;
    }
    return fresh;
  }

  void conclude() {
    if (result_.complete) {
      for (std::size_t c = 0; c < put_.size(); ++c) {
        if (put_[c] && !taken_[c] && !automata_.to_device[c]) result_.untaken.emplace_back(c);
      }
    }
    find_live();
    std::uint32_t total = none;
    std::uint32_t partial = none;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (!nodes_[i].expanded) continue;
      if (nodes_[i].terminal && less(i, total)) total = i;
      if (dead(i, 0) && less(i, partial)) partial = i;
    }
    if (total != none) result_.total = dead_end(total, true);
    // Of two with one cause the one in which all stop says more.
    const bool says_more =
        partial != none && (total == none || nodes_[partial].timely < nodes_[total].timely);
    if (says_more) {
      const auto last = farthest(partial);
      result_.partial = dead_end(partial, false);
      result_.partial->stuck = stuck(last.second);
      result_.partial->run.insert(result_.partial->run.end(), last.first.begin(), last.first.end());
      find_culprit(*result_.partial, partial);
    }
  }

  bool less(std::uint32_t a, std::uint32_t b) const {
    return b == none ||
           std::tie(nodes_[a].timely, nodes_[a].length, a) < std::tie(nodes_[b].timely, nodes_[b].length, b);
  }

  /// live_: the threads that go on in some run from here.
  void find_live() {
    live_.assign(nodes_.size(), 0);
    into_.assign(nodes_.size() + 1, 0);
    for (const auto& edge : edges_) ++into_[edge.to + 1];
    for (std::size_t i = 1; i < into_.size(); ++i) into_[i] += into_[i - 1];
    by_target_.resize(edges_.size());
    auto next = into_;
    for (std::uint32_t e = 0; e < edges_.size(); ++e) by_target_[next[edges_[e].to]++] = e;
    std::deque<std::uint32_t> open;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (!nodes_[i].expanded) live_[i] = ~std::uint64_t{0};
      if (!nodes_[i].expanded) open.push_back(i);
    }
    for (const auto& edge : edges_) {
      live_[edge.from] |= edge.moved;
      open.push_back(edge.from);
    }
    while (!open.empty()) {
      const auto at = open.front();
      open.pop_front();
      for (auto k = into_[at]; k < into_[at + 1]; ++k) {
        const auto from = edges_[by_target_[k]].from;
        const auto with = live_[from] | live_[at];
        if (with == live_[from]) continue;
        live_[from] = with;
        open.push_back(from);
      }
    }
  }

  bool never_moves(std::uint32_t at, std::size_t thread) const {
    return thread < most_told && (live_[at] >> thread & 1) == 0;
  }

  /// The thread can neither go on nor come to its end, whatever happens, because it or its blocks wait for
  /// ever.
  bool dead(std::uint32_t at, std::size_t thread) const {
    const auto& state = *nodes_[at].state;
    if (!moves_.active(state, thread) || !never_moves(at, thread)) return false;
    const auto& step = moves_.at(state, thread);
    if (step.kind != Step::Kind::join) return step.kind == Step::Kind::wait || step.kind == Step::Kind::send;
    const bool ends = !step.next.empty();
    bool some = false;
    bool all = true;
    for (const auto block : automata_.threads[thread].children) {
      if (!moves_.active(state, block)) continue;
      if (ends && !automata_.threads[block].can_end) continue;
      const bool block_is = dead(at, block);
      some = some || block_is;
      all = all && block_is;
    }
    return some && (ends || all);
  }

  std::vector<Deed> run_to(std::uint32_t at) const {
    std::vector<Deed> run;
    for (; nodes_[at].from != none; at = nodes_[at].from) run.push_back(nodes_[at].deed);
    std::reverse(run.begin(), run.end());
    return run;
  }

  std::vector<Stuck> stuck(std::uint32_t at) const {
    std::vector<Stuck> result;
    const auto& state = *nodes_[at].state;
    for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
      if (!moves_.active(state, t)) continue;
      if (!nodes_[at].terminal && !never_moves(at, t)) continue;
      const auto& step = moves_.at(state, t);
      if (step.kind != Step::Kind::wait && step.kind != Step::Kind::send) continue;
      Stuck one{t, static_cast<std::size_t>(&step - automata_.steps.data()), step.kind == Step::Kind::wait};
      for (const auto channel : step.channels) {
        const auto& request = automata_.request_of[channel.index()];
        if (!request || moves_.open(state, *request) > 0) one.never_asked = false;
      }
      result.push_back(one);
    }
    return result;
  }

  DeadEnd dead_end(std::uint32_t at, bool total) const {
    DeadEnd result{total, nodes_[at].timely > 0, run_to(at), stuck(at), 0};
    find_culprit(result, at);
    return result;
  }

  /// The first of the skill method's threads that is stuck for good; without one, the first that is stuck.
  void find_culprit(DeadEnd& end, std::uint32_t at) const {
    for (std::size_t i = end.stuck.size(); i-- > 0;) {
      auto root = end.stuck[i].thread;
      while (automata_.threads[root].parent) root = *automata_.threads[root].parent;
      if (root == 0 && dead(at, end.stuck[i].thread)) end.culprit = i;
    }
  }

  /// The nearest state from here in which as many threads as ever are stuck, and the way there.
  std::pair<std::vector<Deed>, std::uint32_t> farthest(std::uint32_t from) const {
    std::vector<std::vector<std::uint32_t>> out(nodes_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e) out[edges_[e].from].push_back(e);
    std::unordered_map<std::uint32_t, std::uint32_t> by{{from, none}};
    std::deque<std::uint32_t> open{from};
    auto best = from;
    const auto count = [&](std::uint32_t at) { return stuck(at).size(); };
    while (!open.empty()) {
      const auto at = open.front();
      open.pop_front();
      if (count(at) > count(best)) best = at;
      for (const auto e : out[at]) {
        if (!edges_[e].timely && by.emplace(edges_[e].to, e).second) open.push_back(edges_[e].to);
      }
    }
    std::pair<std::vector<Deed>, std::uint32_t> result{{}, best};
    for (auto at = best; by.at(at) != none; at = edges_[by.at(at)].from)
      result.first.push_back(edges_[by.at(at)].deed);
    std::reverse(result.first.begin(), result.first.end());
    return result;
  }

  const Automata& automata_;
  Limits limits_;
  bool reduced_;
  Moves moves_;
  Reduction reduction_;
  std::unordered_map<State, std::uint32_t> seen_;
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  using Entry = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // timely, length, node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::vector<bool> put_;
  std::vector<bool> taken_;
  std::vector<std::uint64_t> live_;
  std::vector<std::size_t> into_;
  std::vector<std::uint32_t> by_target_;
  Findings result_;
};

}  // namespace

Findings explore(const Automata& automata, const Limits& limits, bool reduced) {
  return Explorer(automata, limits, reduced).run();
}

}  // namespace pal::frontend::deadlock
