#include "analyzer/load/grid.hpp"

#include <algorithm>
#include <numeric>

namespace pal::analyzer {
namespace {

constexpr std::size_t tries_between_stops = 4096;
constexpr std::size_t nodes_between_stops = 64;  // each may have very many successors

Nanoseconds down(Nanoseconds value, Nanoseconds unit) {
  const Nanoseconds rest = ((value % unit) + unit) % unit;
  return value - rest;
}

Nanoseconds up(Nanoseconds value, Nanoseconds unit) {
  return -down(-value, unit);
}

/// Greatest unit of which every time of the slice is a multiple.
Nanoseconds unit_of(const Problem& problem, const Slice& slice) {
  Nanoseconds unit = 0;
  const auto add = [&unit](Nanoseconds time) {
    if (time < Range::unbounded) unit = std::gcd(unit, time);
  };
  const auto add_range = [&add](const Range& range) {
    add(range.best);
    add(range.worst);
  };
  for (const StepId s : problem.steps.ids()) {
    if (!slice.steps[s]) continue;
    add_range(problem.steps[s].cost);
    add_range(problem.steps[s].give_up_cost);
    add(problem.steps[s].within.value_or(0));
  }
  add_range(problem.within_processor);
  add_range(problem.between_processors);
  for (const DeviceId d : problem.devices.ids()) {
    if (!slice.devices[d]) continue;
    if (const auto* event = std::get_if<pan::EventDevice>(&problem.devices[d].behaviour)) {
      add(event->period.count());
      add(event->jitter.count());
    } else if (const auto* request = std::get_if<pan::RequestDevice>(&problem.devices[d].behaviour)) {
      add(request->answer.best.count());
      add(request->answer.worst.count());
    } else if (const auto* frames = std::get_if<pan::FrameDevice>(&problem.devices[d].behaviour)) {
      add(frames->period.count());
      add(frames->collecting.count());
    }
  }
  return std::max<Nanoseconds>(unit, 1);
}

}  // namespace

std::size_t Grid::Hash::operator()(const std::vector<Nanoseconds>& key) const {
  std::uint64_t hash = 0x9e3779b97f4a7c15U;
  for (Nanoseconds part : key) {
    hash = (hash ^ static_cast<std::uint64_t>(part)) * 0xff51afd7ed558ccdU;
    hash ^= hash >> 31U;
  }
  return static_cast<std::size_t>(hash);
}

Grid::Grid(const Machine& machine, const Slice& slice) : sliced_(machine), slice_(slice) {
  sliced_.free_conditions = slice.free_conditions;
  unit_ = unit_of(machine.problem(), slice);
  unforced_.assign(static_cast<std::size_t>(machine.timer_count()), false);
  for (const DeviceId d : machine.problem().devices.ids()) {
    const auto* event = std::get_if<pan::EventDevice>(&machine.problem().devices[d].behaviour);
    if (event == nullptr || !event->sporadic) continue;
    unforced_[static_cast<std::size_t>(machine.next_timer(d))] = true;
    sporadic_ = sporadic_ || slice.devices[d];
  }
}

State Grid::masked(State state) const {
  for (const ThreadId t : state.threads.ids()) {
    // A thread that waits for its processor for ever must not get that of a thread that is left out.
    if (!slice_.threads[t]) std::erase(state.queue, static_cast<ThreadNumber>(t.index()));
    if (!slice_.left_out[t]) continue;
    for (ThreadNumber& running : state.running) {
      if (running == static_cast<ThreadNumber>(t.index())) running = -1;
    }
    state.threads[t] = {};
  }
  for (const ChannelId c : state.slots.ids()) {
    if (!slice_.channels[c]) state.slots[c] = {};
  }
  for (const DeviceId d : state.devices.ids()) {
    if (!slice_.devices[d]) state.devices[d] = {};
  }
  state.conditions &= ~slice_.free_conditions;
  return state;
}

int Grid::place_of(State state, std::vector<int> timers, std::vector<bool> frozen) {
  const auto [found, added] = place_index_.try_emplace(std::move(state), static_cast<int>(places_.size()));
  if (added) {
    places_.push_back({found->first, std::move(timers), std::move(frozen)});
    moves_.emplace_back();
    moves_known_.push_back(false);
  }
  return found->second;
}

int Grid::node_of(int place, std::vector<Nanoseconds> left) {
  std::vector<Nanoseconds> key = left;
  key.push_back(place);
  const auto [found, added] = node_index_.try_emplace(std::move(key), static_cast<int>(nodes_.size()));
  if (added) {
    nodes_.push_back({place, std::move(left)});
    origins_.push_back(-1);
  }
  return found->second;
}

bool Grid::start(const ZoneGraph& graph, const Recurrence& recurrence, const Limits& limits) {
  StopToken stop(limits.stop);
  for (int c : recurrence.entries) {
    const ZoneClass& entry = graph.classes()[static_cast<std::size_t>(c)];
    const Place& from = graph.places()[static_cast<std::size_t>(entry.state)];
    std::vector<int> timers;
    std::vector<std::size_t> variables;
    for (std::size_t k = 0; k < from.timers.size(); ++k) {
      if (!slice_.timers[static_cast<std::size_t>(from.timers[k])]) continue;
      if (from.frozen[k]) return false;  // its variable is not what it has left
      timers.push_back(from.timers[k]);
      variables.push_back(k + 1);
    }
    std::vector<bool> frozen(timers.size());
    const int place = place_of(masked(from.state), std::move(timers), std::move(frozen));
    std::vector<Nanoseconds> left;
    points(place, entry.zone, variables, left, c, limits.classes, stop);
    if (nodes_.size() > limits.classes || stop.stop_requested()) return false;
  }
  return !nodes_.empty();
}

/// All multiples of the unit in the zone, its bounds moved out to the next multiple.
void Grid::points(int place, const Dbm& zone, const std::vector<std::size_t>& variables,
                  std::vector<Nanoseconds>& left, int origin, std::size_t most, StopToken& stop) {
  if (nodes_.size() > most) return;
  if (left.size() == variables.size()) {
    const int node = node_of(place, left);
    if (origins_[static_cast<std::size_t>(node)] < 0) origins_[static_cast<std::size_t>(node)] = origin;
    return;
  }
  const std::size_t variable = variables[left.size()];
  Nanoseconds low = std::max<Nanoseconds>(0, down(-zone.at(0, variable), unit_));
  Nanoseconds high = zone.at(variable, 0);
  if (high >= Dbm::unbounded) high = low + unit_;
  high = up(high, unit_);
  const std::vector<int>& timers = places_[static_cast<std::size_t>(place)].timers;
  for (std::size_t k = 0; k < left.size(); ++k) {
    if (may_wait(timers[k])) continue;  // it may come later than from then on
    const Nanoseconds above = zone.at(variable, variables[k]);
    const Nanoseconds below = zone.at(variables[k], variable);
    if (above < Dbm::unbounded) high = std::min(high, left[k] + up(above, unit_));
    if (below < Dbm::unbounded) low = std::max(low, left[k] - up(below, unit_));
  }
  // When an event may come is what is counted down to, not when it comes.
  if (may_wait(timers[left.size()])) high = low;
  for (Nanoseconds value = low; value <= high && nodes_.size() <= most && !stopped_; value += unit_) {
    // Many of them may be known from other classes.
    if (++tried_ % tries_between_stops == 0) stopped_ = stop.stop_requested();
    left.push_back(value);
    points(place, zone, variables, left, origin, most, stop);
    left.pop_back();
  }
}

const std::vector<Grid::Move>& Grid::moves(int place) {
  const auto index = static_cast<std::size_t>(place);
  if (moves_known_[index]) return moves_[index];
  moves_known_[index] = true;
  const GridPlace here = places_[index];
  std::vector<Move> made;
  for (std::size_t k = 0; k < here.timers.size(); ++k) {
    if (here.frozen[k]) continue;
    const ProcessorId processor = sliced_.processor_of(here.state, here.timers[k]);
    bool unfixed = false;
    if (processor.valid()) {
      const Range cost = sliced_.cost(here.state, here.timers[k]);
      for (std::size_t f = 0; f < here.timers.size(); ++f) {
        if (!here.frozen[f]) continue;
        const ThreadId thread = sliced_.thread_of(here.timers[f]);
        if (sliced_.problem().threads[thread].processor == processor && cost.best != cost.worst)
          unfixed = true;
      }
    }
    AllChoices choices;
    do {
      Outcome outcome;
      if (!sliced_.fire(here.state, here.timers[k], choices, false, outcome)) break;
      if (outcome.state.ended || !slice_.positions.contains(position(slice_, outcome.state))) continue;
      Move move{here.timers[k], -1, outcome.changes, unfixed};
      std::vector<int> timers;
      std::vector<bool> frozen;
      for (std::size_t o = 0; o < here.timers.size(); ++o) {
        if (o == k) continue;
        timers.push_back(here.timers[o]);
        frozen.push_back(here.frozen[o]);
      }
      for (const TimerChange& change : outcome.changes) {
        const auto found = std::find(timers.begin(), timers.end(), change.timer);
        const auto at = static_cast<std::size_t>(found - timers.begin());
        if (change.kind == TimerChange::Kind::start) {
          timers.push_back(change.timer);
          frozen.push_back(false);
        } else if (found == timers.end()) {
          continue;
        } else if (change.kind == TimerChange::Kind::stop) {
          timers.erase(found);
          frozen.erase(frozen.begin() + static_cast<std::ptrdiff_t>(at));
        } else {
          frozen[at] = change.kind == TimerChange::Kind::freeze;
        }
      }
      std::vector<std::size_t> order(timers.size());
      std::iota(order.begin(), order.end(), 0U);
      std::sort(order.begin(), order.end(),
                [&](std::size_t a, std::size_t b) { return timers[a] < timers[b]; });
      std::vector<int> sorted;
      std::vector<bool> sorted_frozen;
      for (std::size_t o : order) {
        sorted.push_back(timers[o]);
        sorted_frozen.push_back(frozen[o]);
      }
      move.place = place_of(masked(std::move(outcome.state)), std::move(sorted), std::move(sorted_frozen));
      made.push_back(std::move(move));
    } while (choices.next());
  }
  moves_[index] = std::move(made);
  return moves_[index];
}

bool Grid::explore(const Limits& limits) {
  most_ = limits.classes;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (nodes_.size() > limits.classes || edges_.size() > 8 * limits.classes) return false;
    if (n % nodes_between_stops == 0 && limits.stop && limits.stop()) return false;
    expand(static_cast<int>(n));
  }
  return true;
}

void Grid::expand(int node) {
  const GridNode here = nodes_[static_cast<std::size_t>(node)];
  const std::vector<Move> next = moves(here.place);
  const GridPlace from = places_[static_cast<std::size_t>(here.place)];
  Nanoseconds least = Range::unbounded;
  for (std::size_t k = 0; k < from.timers.size(); ++k) {
    if (!from.frozen[k] && !may_wait(from.timers[k])) least = std::min(least, here.left[k]);
  }
  if (sporadic_) wait(node, from.timers, from.frozen, least);
  for (const Move& move : next) {
    const auto k = static_cast<std::size_t>(std::find(from.timers.begin(), from.timers.end(), move.timer) -
                                            from.timers.begin());
    const Nanoseconds time = may_wait(move.timer) ? 0 : least;
    if (here.left[k] != time) continue;
    relaxed_ = relaxed_ || move.pays_unfixed;
    const std::vector<int> timers = places_[static_cast<std::size_t>(move.place)].timers;
    std::vector<Range> ranges;
    for (int timer : timers) {
      Range range{-1, -1};
      for (const TimerChange& change : move.changes) {
        if (change.timer == timer && change.kind == TimerChange::Kind::start) range = change.range;
      }
      if (range.best >= 0 && may_wait(timer)) range.worst = range.best;
      if (range.best < 0) {
        const auto old = static_cast<std::size_t>(std::find(from.timers.begin(), from.timers.end(), timer) -
                                                  from.timers.begin());
        const Nanoseconds rest = here.left[old] - (from.frozen[old] ? 0 : time);
        const Nanoseconds left = may_wait(timer) ? std::max<Nanoseconds>(rest, 0) : rest;
        range = {left, left};
      }
      ranges.push_back(range);
    }
    std::vector<Nanoseconds> left;
    arrive(node, move, time, left, 0, ranges);
  }
}

/// Time passes until another event may come; where one may come already, step by step.
void Grid::wait(int node, const std::vector<int>& timers, const std::vector<bool>& frozen, Nanoseconds most) {
  const GridNode here = nodes_[static_cast<std::size_t>(node)];
  Nanoseconds step = most;
  for (std::size_t k = 0; k < timers.size(); ++k) {
    if (may_wait(timers[k])) step = std::min(step, std::max(here.left[k], unit_));
  }
  if (step <= 0 || step >= Range::unbounded) return;
  std::vector<Nanoseconds> left = here.left;
  for (std::size_t k = 0; k < timers.size(); ++k) {
    if (!frozen[k]) left[k] -= step;
    if (may_wait(timers[k])) left[k] = std::max<Nanoseconds>(left[k], 0);
  }
  const int to = node_of(here.place, std::move(left));
  edges_.push_back({node, to, step, -1});
}

void Grid::arrive(int from, const Move& move, Nanoseconds time, std::vector<Nanoseconds>& left,
                  std::size_t next, const std::vector<Range>& ranges) {
  if (next == ranges.size()) {
    const int to = node_of(move.place, left);
    edges_.push_back({from, to, time, move.timer});
    return;
  }
  for (Nanoseconds value = ranges[next].best; value <= ranges[next].worst && nodes_.size() <= most_;
       value += unit_) {
    left.push_back(value);
    arrive(from, move, time, left, next + 1, ranges);
    left.pop_back();
  }
}

}  // namespace pal::analyzer
