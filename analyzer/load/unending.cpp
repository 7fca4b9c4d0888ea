#include "analyzer/load/unending.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <unordered_set>

namespace pal::analyzer {
namespace {

constexpr std::size_t most_unending_events = 200'000;
constexpr std::size_t turns_shown = 2;

/// Edges from a start of the grid to the first node of the cycle.
std::vector<int> way_to(const Grid& grid, int goal) {
  std::vector<int> by(grid.nodes().size(), -1);
  std::vector<bool> seen(grid.nodes().size());
  std::vector<std::vector<int>> out(grid.nodes().size());
  for (std::size_t e = 0; e < grid.edges().size(); ++e) {
    out[static_cast<std::size_t>(grid.edges()[e].from)].push_back(static_cast<int>(e));
  }
  std::deque<int> open;
  for (std::size_t n = 0; n < grid.nodes().size(); ++n) {
    if (grid.origins()[n] < 0) continue;
    seen[n] = true;
    open.push_back(static_cast<int>(n));
  }
  while (!open.empty() && !seen[static_cast<std::size_t>(goal)]) {
    const int node = open.front();
    open.pop_front();
    for (int e : out[static_cast<std::size_t>(node)]) {
      const auto to = static_cast<std::size_t>(grid.edges()[static_cast<std::size_t>(e)].to);
      if (seen[to]) continue;
      seen[to] = true;
      by[to] = e;
      open.push_back(static_cast<int>(to));
    }
  }
  std::vector<int> way;
  for (int node = goal; by[static_cast<std::size_t>(node)] >= 0;) {
    way.push_back(by[static_cast<std::size_t>(node)]);
    node = grid.edges()[static_cast<std::size_t>(way.back())].from;
  }
  std::reverse(way.begin(), way.end());
  return way;
}

class Follower {
 public:
  Follower(const Machine& machine, const ZoneGraph& graph, const Recurrence& recurrence, const Slice& slice,
           const Grid& grid, bool worst)
      : machine_(machine), slice_(slice), grid_(grid), worst_(worst), concrete_run_(machine, false) {
    for (int c : recurrence.classes) {
      const ZoneClass& of = graph.classes()[static_cast<std::size_t>(c)];
      inside_.insert(graph.places()[static_cast<std::size_t>(of.state)].state);
    }
  }

  /// The beginning; false: it does not lead where it should.
  bool begin(const std::vector<ScriptedFiring>& script, const GridNode& start) {
    script_ = script;
    for (std::size_t k = 0; k < script.size(); ++k) {
      ScriptedChoices choices(script[k].choices);
      if (k == 0) {
        concrete_run_.begin(choices);
      } else if (!concrete_run_.fire(script[k].timer, script[k].at, choices)) {
        return false;
      }
    }
    for (std::size_t t = 0; t < concrete_run_.timers().size(); ++t) {
      ConcreteRun::Timer& timer = concrete_run_.timers()[t];
      if (timer.active && !slice_.timers[t])
        last(timer, concrete_run_.worked(static_cast<int>(t), concrete_run_.now()));
    }
    return agree(start);
  }

  /// One edge of the slice, and all that happens beside it before.
  bool follow(const GridEdge& edge) {
    const GridNode& target = grid_.nodes()[static_cast<std::size_t>(edge.to)];
    for (;;) {
      int first = -1;
      Nanoseconds least = Range::unbounded;
      for (std::size_t t = 0; t < concrete_run_.timers().size(); ++t) {
        const ConcreteRun::Timer& timer = concrete_run_.timers()[t];
        if (!timer.active || timer.frozen || timer.duration >= Range::unbounded) continue;
        const bool ours = slice_.timers[t];
        if (ours && static_cast<int>(t) != edge.timer) continue;
        const Nanoseconds left =
            timer.duration - concrete_run_.worked(static_cast<int>(t), concrete_run_.now());
        // What happens beside goes first.
        if (left < least || (left == least && !ours)) {
          least = left;
          first = static_cast<int>(t);
        }
      }
      if (first < 0 || least < 0 || script_.size() > most_unending_events) return false;
      const bool ours = first == edge.timer;
      if (!fire(first, concrete_run_.now() + least, ours ? &target : nullptr)) return false;
      if (ours) return agree(target);
    }
  }

  /// Everything that decides how it goes on.
  std::pair<State, std::vector<Nanoseconds>> situation() const {
    std::vector<Nanoseconds> left;
    for (std::size_t t = 0; t < concrete_run_.timers().size(); ++t) {
      const ConcreteRun::Timer& timer = concrete_run_.timers()[t];
      if (!timer.active) {
        left.push_back(-1);
      } else if (timer.duration >= Range::unbounded) {
        left.push_back(Range::unbounded);
      } else {
        left.push_back(timer.duration - concrete_run_.worked(static_cast<int>(t), concrete_run_.now()));
      }
    }
    return {concrete_run_.state(), std::move(left)};
  }

  const std::vector<ScriptedFiring>& script() const { return script_; }

 private:
  /// What may wait as long as it likes does not come.
  void last(ConcreteRun::Timer& timer, Nanoseconds worked) const {
    timer.duration = worst_ || timer.range.worst >= Range::unbounded ? timer.range.worst
                                                                     : std::max(timer.range.best, worked);
  }

  /// Fires with choices that keep the run inside, and, if it is the slice's turn, take it to `target`.
  bool fire(int timer, Nanoseconds at, const GridNode* target) {
    AllChoices choices;
    do {
      Outcome outcome;
      if (!machine_.fire(concrete_run_.state(), timer, choices, false, outcome)) return false;
      if (!inside_.contains(outcome.state)) continue;
      if (target != nullptr &&
          grid_.masked(outcome.state) != grid_.places()[static_cast<std::size_t>(target->place)].state) {
        continue;
      }
      const std::vector<std::uint8_t> taken = choices.taken();
      ScriptedChoices script(taken);
      concrete_run_.fire(timer, at, script);
      script_.push_back({timer, taken, at});
      for (int started : concrete_run_.started()) {
        if (!slice_.timers[static_cast<std::size_t>(started)])
          last(concrete_run_.timers()[static_cast<std::size_t>(started)], 0);
      }
      return true;
    } while (choices.next());
    return false;
  }

  /// Gives the slice's new timers the time that `node` wants; false: an old one has another.
  bool agree(const GridNode& node) {
    const GridPlace& place = grid_.places()[static_cast<std::size_t>(node.place)];
    for (std::size_t k = 0; k < place.timers.size(); ++k) {
      ConcreteRun::Timer& timer = concrete_run_.timers()[static_cast<std::size_t>(place.timers[k])];
      if (!timer.active) return false;
      const Nanoseconds duration = concrete_run_.worked(place.timers[k], concrete_run_.now()) + node.left[k];
      if (duration < timer.range.best || duration > timer.range.worst) return false;
      timer.duration = duration;
    }
    return true;
  }

  const Machine& machine_;
  const Slice& slice_;
  const Grid& grid_;
  bool worst_;
  ConcreteRun concrete_run_;
  std::unordered_set<State, StateHash> inside_;
  std::vector<ScriptedFiring> script_;
};

}  // namespace

std::optional<Witness> unending_run(const Machine& machine, const ZoneGraph& graph,
                                    const Recurrence& recurrence, const Slice& slice, const Grid& grid,
                                    const std::vector<int>& cycle) {
  const auto edge = [&grid](int e) -> const GridEdge& { return grid.edges()[static_cast<std::size_t>(e)]; };
  const std::vector<int> way = way_to(grid, edge(cycle.front()).from);
  const int start = way.empty() ? edge(cycle.front()).from : edge(way.front()).from;
  const int origin = grid.origins()[static_cast<std::size_t>(start)];
  if (origin < 0) return std::nullopt;
  const GridNode& first = grid.nodes()[static_cast<std::size_t>(start)];
  std::vector<std::pair<int, Nanoseconds>> left;
  const std::vector<int>& timers = grid.places()[static_cast<std::size_t>(first.place)].timers;
  for (std::size_t k = 0; k < timers.size(); ++k) left.emplace_back(timers[k], first.left[k]);
  const auto beginning = script_to(machine, graph, origin, left);
  if (!beginning) return std::nullopt;
  for (const bool worst : {true, false}) {
    Follower follower(machine, graph, recurrence, slice, grid, worst);
    if (!follower.begin(*beginning, first)) continue;
    bool good = true;
    for (std::size_t k = 0; good && k < way.size(); ++k) good = follower.follow(edge(way[k]));
    std::map<std::vector<Nanoseconds>, std::vector<State>> seen;
    std::size_t shown = 0;
    for (std::size_t turn = 0; good; ++turn) {
      if (turn == turns_shown) shown = follower.script().size();
      auto [state, times] = follower.situation();
      std::vector<State>& there = seen[std::move(times)];
      if (std::find(there.begin(), there.end(), state) != there.end()) {
        std::vector<ScriptedFiring> script = follower.script();
        if (shown > 0) script.resize(shown);
        return replay(machine, script);
      }
      there.push_back(std::move(state));
      for (std::size_t k = 0; good && k < cycle.size(); ++k) good = follower.follow(edge(cycle[k]));
    }
  }
  return std::nullopt;
}

}  // namespace pal::analyzer
