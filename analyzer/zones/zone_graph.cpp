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

/// So many classes of a place are kept apart before new ones are widened.
constexpr std::size_t most_apart = 6;

/// Bounds that differ by more count as if they differed by this: some are unbounded.
constexpr std::int64_t longest_apart = std::int64_t{1} << 40U;

/// Arrivals have numbers below those of classes, and below -1, which is none.
int number_of_arrival(std::size_t index) {
  return -2 - static_cast<int>(index);
}
std::size_t arrival_of(int number) {
  return static_cast<std::size_t>(-2 - number);
}

bool around(const ZoneClass& outer, const ZoneClass& inner, ZoneGraph::Merging merging) {
  const bool equal = merging != ZoneGraph::Merging::equal || inner.zone.includes(outer.zone);
  const bool sure = !outer.relaxed || inner.relaxed || merging == ZoneGraph::Merging::hull;
  return sure && equal && outer.zone.includes(inner.zone);
}

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

/// Whether a value that still grows is known to be beyond the cap.
bool grows_beyond(const State& state, const Watch& watch) {
  if (!watch.grows()) return false;
  if (watch.kind != Watch::Kind::response) return state.reference == tag::over;
  return std::find(state.pending.begin(), state.pending.end(), Pending::over) != state.pending.end();
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
/// B. Kahn, Topological sorting of large networks, 1962) has somebody before it that is left, too.
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

void ZoneGraph::merge(std::size_t expanded, const Limits& limits) {
  arrivals_.clear();
  landings_.clear();
  for (std::size_t e = 0; e < expanded; ++e) {
    Expansion& expansion = expansions_[e];
    findings_.add(expansion.findings, machine_.watch().least);
    for (std::size_t a = 0; a < expansion.used; ++a) {
      Arrival& arrival = expansion.arrivals[a];
      const std::size_t index = arrivals_.size();
      arrivals_.push_back(&arrival);
      arrival.made.state = place_of(arrival);
      int& landing = landing_of_[static_cast<std::size_t>(arrival.made.state)];
      if (landing < 0) {
        landing = static_cast<int>(landings_.size());
        landings_.push_back({arrival.made.state, index, index, 1});
        continue;
      }
      Landing& chain = landings_[static_cast<std::size_t>(landing)];
      arrivals_[chain.last]->next = index;
      chain.last = index;
      ++chain.count;
    }
  }
  // The most work first, so that no worker waits for one that began it last.
  const auto work = [this](const Landing& landing) {
    return landing.count * (1 + known_[static_cast<std::size_t>(landing.place)].ids().size());
  };
  std::sort(landings_.begin(), landings_.end(),
            [&](const Landing& a, const Landing& b) { return work(a) > work(b); });
  in_parts(limits, landings_.size(), 1, [this](std::size_t i) { compare(landings_[i]); });
  enter();
  for (const Landing& landing : landings_) {
    const auto place = static_cast<std::size_t>(landing.place);
    landing_of_[place] = -1;
    std::vector<int>& ids = known_[place].ids();
    // New ones stand at the end.
    for (std::size_t k = ids.size(); k-- > 0 && ids[k] < -1;) ids[k] = arrivals_[arrival_of(ids[k])]->number;
  }
}

const ZoneClass& ZoneGraph::zone_class(int id) const {
  return id < -1 ? arrivals_[arrival_of(id)]->made : classes_[static_cast<std::size_t>(id)];
}

/// Makes the class as large as is needed to hold one of those known as well: that to which it is nearest. Of
/// two closed zones the greater bounds are closed.
void ZoneGraph::widen(ZoneClass& made, const KnownZones& known) const {
  const Dbm* nearest = nullptr;
  std::int64_t least = INT64_MAX;
  const std::size_t size = made.zone.size();
  for (const int id : known.ids()) {
    const Dbm& other = zone_class(id).zone;
    std::int64_t added = 0;
    for (std::size_t i = 0; i < size && added < least; ++i) {
      for (std::size_t j = 0; j < size; ++j)
        added += std::min(std::abs(other.at(i, j) - made.zone.at(i, j)), longest_apart);
    }
    if (added >= least) continue;
    least = added;
    nearest = &other;
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j)
      made.zone.at(i, j) = std::max(made.zone.at(i, j), nearest->at(i, j));
  }
  made.relaxed = true;
}

void ZoneGraph::compare(const Landing& landing) {
  KnownZones& known = known_[static_cast<std::size_t>(landing.place)];
  Outline outline;
  std::size_t index = landing.first;
  for (std::size_t k = 0; k < landing.count; ++k, index = arrivals_[index]->next) {
    Arrival& arrival = *arrivals_[index];
    outline.of(arrival.made.zone);
    arrival.held_by =
        known.first_around(outline, [&](int id) { return around(zone_class(id), arrival.made, merging_); });
    if (arrival.held_by != -1) continue;
    if (merging_ == Merging::hull && known.ids().size() >= most_apart) {
      widen(arrival.made, known);
      outline.of(arrival.made.zone);
    }
    known.erase_within(outline, [&](int id) {
      if (!around(arrival.made, zone_class(id), merging_)) return false;
      arrival.replaces.push_back(id);
      return true;
    });
    known.add(number_of_arrival(index), outline);
  }
}

void ZoneGraph::enter() {
  const auto number_of = [&](int id) { return id < -1 ? arrivals_[arrival_of(id)]->number : id; };
  std::vector<Arrival*> entering;
  for (Arrival* arrival : arrivals_) {
    const bool enters = arrival->held_by == -1;
    arrival->number =
        enters ? static_cast<int>(classes_.size() + entering.size()) : number_of(arrival->held_by);
    if (enters) entering.push_back(arrival);
    if (arrival->made.parent < 0) continue;
    const int parent = arrival->made.parent;
    const int place = classes_[static_cast<std::size_t>(parent)].state;
    const auto beyond = [this](int at) {
      return grows_beyond(places_[static_cast<std::size_t>(at)].state, machine_.watch());
    };
    if (beyond(place) && beyond(arrival->made.state)) {
      growing_.emplace_back(parent, arrival->number);
      if (!arrival->move->outcome.over_gone) growing_on_.push_back(growing_.back());
    }
    if (!keep_edges_) continue;
    edges_.push_back({parent, arrival->number, arrival->move->timer, arrival->made.move});
  }
  for (Arrival* arrival : entering) {
    memory_ += memory_of(arrival->made.zone);
    classes_.push_back(std::move(arrival->made));
    open_.push_back(arrival->number);
    for (int id : arrival->replaces) {
      ZoneClass& replaced = classes_[static_cast<std::size_t>(number_of(id))];
      replaced.replaced_by = arrival->number;
      // Only its ancestry is asked for again, so the next arrival may have its memory.
      arrival->made.zone = std::exchange(replaced.zone, Dbm(0));
    }
  }
}

}  // namespace pal::analyzer
