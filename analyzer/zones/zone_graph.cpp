#include "analyzer/zones/zone_graph.hpp"

#include <algorithm>
#include <utility>

#include "analyzer/zones/cost.hpp"

namespace pal::analyzer {
namespace {

/// How many classes are expanded before their successors are compared. They are enough to share among
/// threads. They are few enough that not many are expanded that a successor would have replaced.
constexpr std::size_t batch_size = 2048;

/// Places whose firings are found between one question whether to stop and the next: one may have thousands.
constexpr std::size_t tried_at_a_time = 128;

/// So many classes are found sooner by one thread than by several that have to wait for one another.
constexpr std::size_t worth_sharing = 8192;

bool anything_grows(const State& state, const Watch& watch) {
  if (!watch.grows()) return false;
  if (watch.kind != Watch::Kind::response) return state.reference != tag::none;
  return std::any_of(state.pending.begin(), state.pending.end(),
                     [](Pending pending) { return pending != Pending::outside; });
}

/// Whether nothing ever has to happen: no timer is left, or only those of sporadic events.
bool may_stay(const Dbm& zone, std::size_t timers) {
  for (std::size_t k = 1; k <= timers; ++k) {
    if (zone.at(k, 0) < Dbm::unbounded) return false;
  }
  return true;
}

}  // namespace

void ZoneGraph::in_parts(const Limits& limits, std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t)>& part) const {
  if (limits.workers != nullptr && classes_.size() >= worth_sharing) {
    return limits.workers->each(count, grain, part);
  }
  for (std::size_t i = 0; i < count; ++i) part(i);
}

ZoneGraph::ZoneGraph(const Machine& machine, Nanoseconds cap, bool keep_edges, Merging merging)
    : machine_(machine), cap_(cap), keep_edges_(keep_edges), merging_(merging) {}

int ZoneGraph::current(int index) const {
  while (classes_[static_cast<std::size_t>(index)].replaced_by >= 0) {
    index = classes_[static_cast<std::size_t>(index)].replaced_by;
  }
  return index;
}

/// Each class that was replaced leads at once to the one that counts. Without this, a class that has grown
/// with every turn of a loop would have very long ways.
void ZoneGraph::shorten_ways() {
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    const int last = current(static_cast<int>(i));
    for (auto at = i; static_cast<int>(at) != last;) {
      const auto next = static_cast<std::size_t>(classes_[at].replaced_by);
      classes_[at].replaced_by = last;
      at = next;
    }
  }
}

const Move& ZoneGraph::move_to(const ZoneClass& made) const {
  const std::vector<Move>& moves =
      made.parent < 0
          ? first_moves_
          : places_[static_cast<std::size_t>(classes_[static_cast<std::size_t>(made.parent)].state)].moves;
  return moves[static_cast<std::size_t>(made.move)];
}

void ZoneGraph::Expansion::begin() {
  used = 0;
  findings = {};
}

ZoneGraph::Arrival& ZoneGraph::Expansion::arrival(Move& move) {
  if (used == arrivals.size()) arrivals.emplace_back();
  Arrival& arrival = arrivals[used++];
  arrival.move = &move;
  arrival.passed.reset();
  arrival.replaces.clear();
  return arrival;
}

bool ZoneGraph::explore(const Limits& limits) {
  const bool complete = grow(limits);
  shorten_ways();
  // Also where a limit was met: edges lead to and from classes that others have replaced.
  for (Edge& edge : edges_) {
    edge.from = current(edge.from);
    edge.to = current(edge.to);
  }
  // If the skill ends on every way on, what has grown is not counted.
  round_ = on_a_round(growing_on_);
  findings_.never_answered = findings_.never_answered || on_a_round(growing_) >= 0;
  findings_.grows_on = findings_.grows_on || round_ >= 0;
  growing_ = {};
  growing_on_ = {};
  return complete;
}

/// A class on a way round; -1: there is none. What is left when all is taken away to which nothing leads (A.
/// B. Kahn, Topological sorting of large networks, 1962) has one before it that is left, too.
int ZoneGraph::on_a_round(const std::vector<std::pair<int, int>>& edges) const {
  std::unordered_map<int, int> entering;
  std::unordered_map<int, std::vector<int>> leaving;
  for (const auto& [parent, made] : edges) {
    const int from = current(parent);
    const int to = current(made);
    entering.try_emplace(from, 0);
    ++entering[to];
    leaving[from].push_back(to);
  }
  std::vector<int> free;
  for (const auto& [node, count] : entering) {
    if (count == 0) free.push_back(node);
  }
  for (std::size_t done = 0; done < free.size(); ++done) {
    for (const int to : leaving[free[done]]) {
      if (--entering[to] == 0) free.push_back(to);
    }
  }
  if (free.size() == entering.size()) return -1;
  std::unordered_map<int, int> before;
  for (const auto& [parent, made] : edges) {
    if (entering[current(parent)] > 0) before[current(made)] = current(parent);
  }
  int at = before.begin()->first;
  for (std::size_t step = 0; step < before.size(); ++step) at = before.at(at);
  return at;
}

bool ZoneGraph::grow(const Limits& limits) {
  StopToken stop(limits.stop);
  expansions_.resize(batch_size);
  if (stop.stop_requested()) return false;
  first_moves_ = first_moves(machine_, stop);
  if (stop.stop_requested()) return false;
  for (Move& move : first_moves_) {
    Expansion& expansion = expansions_.front();
    expansion.findings.outgrown |= move.outcome.too_many;
    expansion.findings.passed |= move.outcome.passed;
    Arrival& arrival = expansion.arrival(move);
    arrival.made.move = static_cast<int>(&move - first_moves_.data());
    follow(ZoneClass(), Dbm(1), move, 0, expansion.sources, arrival.made);
    observe_growth(arrival, expansion.findings);
    split(arrival, expansion);
  }
  merge(1, limits);
  while (!open_.empty() && !findings_.failure && !findings_.outgrown) {
    if (classes_.size() > limits.classes || memory_ > memory_for(limits.classes)) return false;
    if (stop.stop_requested()) return false;
    if (limits.enough && limits.enough(*this)) return false;
    std::vector<int> batch;
    std::vector<int> untried;
    std::size_t work = 0;
    while (!open_.empty() && batch.size() < batch_size && work < batch_work) {
      const int next = open_.front();
      open_.pop_front();
      const ZoneClass& of = classes_[static_cast<std::size_t>(next)];
      if (of.replaced_by >= 0) continue;
      batch.push_back(next);
      Place& place = places_[static_cast<std::size_t>(of.state)];
      work += work_of(of.zone, place.timers.size());
      if (!place.moves_known) untried.push_back(of.state);
      place.moves_known = true;
    }
    if (!try_all(untried, limits, stop)) return false;
    for (int place : untried) memory_ += memory_of_moves(places_[static_cast<std::size_t>(place)]);
    in_parts(limits, batch.size(), 8, [&](std::size_t i) { expand(batch[i], expansions_[i]); });
    merge(batch.size(), limits);
  }
  return !findings_.outgrown;
}

/// Finds where the places lead to. False: it was told to stop.
bool ZoneGraph::try_all(const std::vector<int>& untried, const Limits& limits, StopToken& stop) {
  for (std::size_t from = 0; from < untried.size(); from += tried_at_a_time) {
    in_parts(limits, std::min(tried_at_a_time, untried.size() - from), 4, [&](std::size_t i) {
      Place& place = places_[static_cast<std::size_t>(untried[from + i])];
      if (!place.state.ended) place.moves = moves_from(machine_, place, stop);
    });
    if (stop.stop_requested()) return false;
  }
  return true;
}

void ZoneGraph::expand(int index, Expansion& expansion) {
  const ZoneClass& from = classes_[static_cast<std::size_t>(index)];
  Place& here = places_[static_cast<std::size_t>(from.state)];
  expansion.begin();
  if (here.state.ended) return;
  if (anything_grows(here.state, machine_.watch()) && may_stay(from.zone, here.timers.size())) {
    expansion.findings.stuck = index;
    expansion.findings.never_answered = true;
    expansion.findings.grows_on = true;
  }
  int fired_timer = -1;
  bool possible = false;
  for (Move& move : here.moves) {
    if (move.timer != fired_timer) {
      fired_timer = move.timer;
      expansion.fired = from.zone;
      possible = fire_first(expansion.fired, move.variable, here.frozen);
    }
    if (!possible) continue;
    expansion.findings.outgrown |= move.outcome.too_many;
    measure(index, move, expansion.fired, here.timers.size(), expansion.findings);
    Arrival& arrival = expansion.arrival(move);
    arrival.made.parent = index;
    arrival.made.move = static_cast<int>(&move - here.moves.data());
    const bool left =
        follow(from, expansion.fired, move, here.timers.size(), expansion.sources, arrival.made);
    expansion.findings.relaxed |= arrival.made.relaxed;
    if (left) {
      observe_growth(arrival, expansion.findings);
      split(arrival, expansion);
    } else {
      --expansion.used;
    }
  }
}

/// An observer that may be beyond the cap is two cases: within it, and beyond.
void ZoneGraph::split(Arrival& arrival, Expansion& expansion) const {
  const std::size_t first = 1 + arrival.move->timers.size();
  std::size_t variable = first;
  while (variable < arrival.made.zone.size() && arrival.made.zone.at(0, variable) <= cap_) ++variable;
  if (variable == arrival.made.zone.size()) return;

  // Making arrivals moves those that there are.
  Move& move = *arrival.move;
  ZoneClass made = arrival.made;
  const std::optional<State> passed = arrival.passed;
  --expansion.used;
  ZoneClass beyond = made;
  if (beyond.zone.constrain(variable, 0, -cap_ - 1)) {
    expansion.sources.clear();
    for (std::size_t v = 0; v < made.zone.size(); ++v) {
      if (v != variable) expansion.sources.push_back({v, 0, 0});
    }
    const Dbm whole = beyond.zone;
    derive(whole, expansion.sources, beyond.zone);
    Arrival& later = expansion.arrival(move);
    later.passed = passed ? *passed : move.outcome.state;
    pass_cap(*later.passed, machine_.watch(), static_cast<int>(variable - first));
    later.made = std::move(beyond);
    split(later, expansion);
  }
  if (!made.zone.constrain(0, variable, cap_)) return;
  Arrival& within = expansion.arrival(move);
  within.passed = passed;
  within.made = std::move(made);
  split(within, expansion);
}

int ZoneGraph::place_of(Arrival& arrival) {
  Move& move = *arrival.move;
  if (!arrival.passed && move.target >= 0) return move.target;
  const State& state = arrival.passed ? *arrival.passed : move.outcome.state;
  const auto [found, added] = index_.try_emplace(state, static_cast<int>(places_.size()));
  if (added) {
    places_.push_back({state, move.numbers, move.frozen, {}, false});
    known_.emplace_back();
    landing_of_.push_back(-1);
  }
  if (!arrival.passed) move.target = found->second;
  return found->second;
}

}  // namespace pal::analyzer
