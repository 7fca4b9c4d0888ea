#include "analyzer/zone_graph.hpp"

#include <algorithm>

namespace pal::analyzer {
namespace {

/// Where a variable of the next class comes from: an old one, moved by something in [low, high].
struct Source {
  std::size_t variable;
  Nanoseconds low;
  Nanoseconds high;
};

Dbm derived(const Dbm& from, const std::vector<Source>& sources) {
  Dbm made(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (std::size_t j = 0; j < sources.size(); ++j) {
      if (i == j) continue;
      const Nanoseconds between = from.at(sources[i].variable, sources[j].variable);
      made.at(i, j) = sources[i].high >= Range::unbounded
                          ? Dbm::unbounded
                          : Dbm::sum(between, sources[i].high - sources[j].low);
    }
  }
  return made;
}

/// Only runs in which the timer of `variable` is the first to fire. False: there is none.
bool fire_first(Dbm& zone, std::size_t variable, const std::vector<bool>& frozen) {
  for (std::size_t k = 0; k < frozen.size(); ++k) {
    if (frozen[k] || k + 1 == variable) continue;
    if (!zone.constrain(variable, k + 1, 0)) return false;
  }
  return true;
}

std::size_t position(const std::vector<int>& timers, int timer) {
  return static_cast<std::size_t>(std::find(timers.begin(), timers.end(), timer) - timers.begin());
}

}  // namespace

ZoneGraph::ZoneGraph(const Machine& machine, Nanoseconds cap, bool keep_edges)
    : machine_(machine), cap_(cap), keep_edges_(keep_edges) {}

int ZoneGraph::current(int index) const {
  while (classes_[static_cast<std::size_t>(index)].replaced_by >= 0) {
    index = classes_[static_cast<std::size_t>(index)].replaced_by;
  }
  return index;
}

int ZoneGraph::place_of(State state, std::vector<int> timers, std::vector<bool> frozen) {
  const auto [found, added] = index_.try_emplace(std::move(state), static_cast<int>(places_.size()));
  if (added) {
    places_.push_back({found->first, std::move(timers), std::move(frozen), std::nullopt});
    classes_of_.emplace_back();
  }
  return found->second;
}

bool ZoneGraph::explore(const Limits& limits) {
  AllChoices choices;
  do {
    Transition start;
    start.outcome = machine_.initial(choices, false);
    start.choices = choices.taken();
    outgrown_ = outgrown_ || start.outcome.too_many;
    passed_ = passed_ || start.outcome.passed;
    follow(-1, start, Dbm(1), 0);
  } while (choices.next());
  std::size_t rounds = 0;
  while (!open_.empty() && !failure_ && !outgrown_) {
    if (classes_.size() > limits.classes) return false;
    if (++rounds % 256 == 0 && limits.stop && limits.stop()) return false;
    const int next = open_.front();
    open_.pop_front();
    if (classes_[static_cast<std::size_t>(next)].replaced_by < 0) expand(next);
  }
  for (Edge& edge : edges_) {
    edge.from = current(edge.from);
    edge.to = current(edge.to);
  }
  return !outgrown_;
}

void ZoneGraph::compute_transitions(int index) {
  std::vector<Transition> transitions;
  const std::vector<int> timers = places_[static_cast<std::size_t>(index)].timers;
  const std::vector<bool> frozen = places_[static_cast<std::size_t>(index)].frozen;
  const State state = places_[static_cast<std::size_t>(index)].state;
  for (std::size_t k = 0; k < timers.size(); ++k) {
    if (frozen[k]) continue;
    AllChoices choices;
    do {
      Transition made;
      if (!machine_.fire(state, timers[k], choices, false, made.outcome)) break;
      made.timer = timers[k];
      made.choices = choices.taken();
      transitions.push_back(std::move(made));
    } while (choices.next());
  }
  places_[static_cast<std::size_t>(index)].transitions = std::move(transitions);
}

void ZoneGraph::expand(int index) {
  const int place = classes_[static_cast<std::size_t>(index)].state;
  {
    const Place& here = places_[static_cast<std::size_t>(place)];
    if (here.state.ended) return;
    if (here.timers.empty() && machine_.watch().grows() && here.state.observers > 0) {
      const bool growing =
          machine_.watch().kind == Watch::Kind::response || here.state.reference != tag::none;
      if (growing && stuck_ < 0) stuck_ = index;
      never_answered_ = never_answered_ || growing;
    }
    if (!here.transitions) compute_transitions(place);
  }
  // Following may add places, and so move them: the transitions are held while it does.
  const std::vector<Transition> transitions =
      std::move(*places_[static_cast<std::size_t>(place)].transitions);
  const std::vector<int> timers = places_[static_cast<std::size_t>(place)].timers;
  const std::vector<bool> frozen = places_[static_cast<std::size_t>(place)].frozen;
  int fired_timer = -1;
  bool possible = false;
  Dbm fired;
  std::size_t variable = 0;
  for (const Transition& transition : transitions) {
    if (transition.timer != fired_timer) {
      fired_timer = transition.timer;
      variable = position(timers, fired_timer) + 1;
      fired = classes_[static_cast<std::size_t>(index)].zone;
      possible = fire_first(fired, variable, frozen);
    }
    if (!possible) continue;
    outgrown_ = outgrown_ || transition.outcome.too_many;
    measure(index, transition, fired, variable);
    follow(index, transition, fired, variable);
  }
  places_[static_cast<std::size_t>(place)].transitions = std::move(transitions);
}

void ZoneGraph::measure(int from, const Transition& transition, const Dbm& fired, std::size_t variable) {
  const ZoneClass& parent = classes_[static_cast<std::size_t>(from)];
  const std::size_t timers = places_[static_cast<std::size_t>(parent.state)].timers.size();
  const bool least = machine_.watch().least;
  const Outcome& outcome = transition.outcome;
  passed_ = passed_ || outcome.passed;
  Peak peak;
  peak.parent = from;
  peak.timer = transition.timer;
  peak.choices = transition.choices;
  peak.relaxed = parent.relaxed;
  for (std::size_t i = 0; i < outcome.measured.size(); ++i) {
    peak.measured = outcome.measured[i];
    peak.step = outcome.measured_steps[i];
    if (peak.measured == Outcome::older_than_cap) {
      over_cap_ = true;
      continue;
    }
    const std::size_t observer = 1 + timers + static_cast<std::size_t>(std::max(peak.measured, 0));
    peak.value = peak.measured == Outcome::born_now ? 0
                 : least                            ? -fired.at(observer, variable)
                                                    : fired.at(variable, observer);
    const bool first = peak_.value < 0;
    if (first || (least ? peak.value < peak_.value : peak.value > peak_.value)) peak_ = peak;
  }
  if (outcome.lost > peak_.value) {
    peak.value = outcome.lost;
    peak.measured = Outcome::born_now;
    peak_ = peak;
  }
  if (outcome.state.failed && !failure_) failure_ = peak;
}

/// What grows counts as soon as it is greater than the limit, whether it is ever measured or not.
void ZoneGraph::observe_growth(int from, const Transition& transition, const ZoneClass& made,
                               std::size_t timers) {
  const Watch& watch = machine_.watch();
  if (growing_ || !watch.grows()) return;
  for (int o = 0; o < transition.outcome.state.observers; ++o) {
    const Nanoseconds value = made.zone.at(0, 1 + timers + static_cast<std::size_t>(o));
    if (value <= watch.limit || !grows(transition.outcome.state, watch, o)) continue;
    growing_ = Peak{value, from, transition.timer, transition.choices, o, -1, made.relaxed, true};
    return;
  }
}

void ZoneGraph::follow(int from, const Transition& transition, const Dbm& fired, std::size_t variable) {
  static const std::vector<int> none;
  static const std::vector<bool> none_frozen;
  const int place = from < 0 ? -1 : classes_[static_cast<std::size_t>(from)].state;
  const std::vector<int>& old_timers = place < 0 ? none : places_[static_cast<std::size_t>(place)].timers;
  const std::vector<bool>& old_frozen =
      place < 0 ? none_frozen : places_[static_cast<std::size_t>(place)].frozen;

  // The timers that there are now: by number, where from, and whether frozen.
  struct Timer {
    int timer;
    Source source;
    bool frozen;
  };
  std::vector<Timer> timers;
  for (std::size_t k = 0; k < old_timers.size(); ++k) {
    if (old_timers[k] == transition.timer) continue;
    timers.push_back({old_timers[k], {k + 1, 0, 0}, old_frozen[k]});
  }
  // An action that ends gives back its time to those that were preempted on its processor: they have as much
  // left as before.
  bool relaxed = from >= 0 && classes_[static_cast<std::size_t>(from)].relaxed;
  std::vector<std::pair<int, Range>> repaid;  // timer, what it can have left
  const int processor =
      place < 0 ? -1
                : machine_.processor_of(places_[static_cast<std::size_t>(place)].state, transition.timer);
  if (processor >= 0) {
    const State& state = places_[static_cast<std::size_t>(place)].state;
    const Range cost = machine_.cost(state, transition.timer);
    const auto priority = [this](int timer) {
      return machine_.problem().threads[static_cast<std::size_t>(timer)].priority;
    };
    std::vector<int> preempted;
    for (Timer& timer : timers) {
      if (!timer.frozen ||
          machine_.problem().threads[static_cast<std::size_t>(timer.timer)].processor != processor)
        continue;
      timer.source.low += cost.best;
      timer.source.high += cost.worst;
      if (cost.best != cost.worst) preempted.push_back(timer.timer);
    }
    for (int timer : preempted) {
      relaxed = relaxed_ = true;
      // Those that interrupted it, and were interrupted themselves, have not given back theirs yet.
      Range left{0, machine_.cost(state, timer).worst};
      for (int other : preempted) {
        if (priority(other) > priority(timer)) left.best -= machine_.cost(state, other).worst;
      }
      repaid.emplace_back(timer, left);
    }
  }
  for (const TimerChange& change : transition.outcome.changes) {
    const auto found =
        std::find_if(timers.begin(), timers.end(), [&](const Timer& t) { return t.timer == change.timer; });
    switch (change.kind) {
      case TimerChange::Kind::start:
        timers.push_back({change.timer, {variable, change.range.best, change.range.worst}, false});
        break;
      case TimerChange::Kind::stop:
        timers.erase(found);
        break;
      case TimerChange::Kind::freeze:
        found->frozen = true;
        break;
      case TimerChange::Kind::resume:
        found->frozen = false;
        break;
    }
  }
  std::sort(timers.begin(), timers.end(), [](const Timer& a, const Timer& b) { return a.timer < b.timer; });

  std::vector<Source> sources{{variable, 0, 0}};
  std::vector<int> numbers;
  std::vector<bool> frozen;
  ZoneClass made;
  for (const Timer& timer : timers) {
    sources.push_back(timer.source);
    numbers.push_back(timer.timer);
    frozen.push_back(timer.frozen);
  }
  for (int origin : transition.outcome.origin) {
    sources.push_back(
        {origin < 0 ? variable : 1 + old_timers.size() + static_cast<std::size_t>(origin), 0, 0});
  }
  made.zone = derived(fired, sources);
  made.relaxed = relaxed;
  for (const auto& [timer, left] : repaid) {
    const std::size_t v = position(numbers, timer) + 1;
    if (!made.zone.constrain(0, v, -left.best) || !made.zone.constrain(v, 0, left.worst)) return;
  }
  observe_growth(from, transition, made, timers.size());
  split(from, transition, transition.outcome.state, std::move(numbers), std::move(frozen), std::move(made));
}

/// An observer that may be beyond the cap is two cases: within it, and beyond.
void ZoneGraph::split(int from, const Transition& transition, State state, std::vector<int> timers,
                      std::vector<bool> frozen, ZoneClass made) {
  for (std::size_t o = 0; o < state.observers; ++o) {
    const std::size_t variable = 1 + timers.size() + o;
    if (made.zone.at(0, variable) <= cap_) continue;
    ZoneClass beyond = made;
    if (beyond.zone.constrain(variable, 0, -cap_ - 1)) {
      std::vector<Source> kept;
      for (std::size_t v = 0; v < beyond.zone.size(); ++v) {
        if (v != variable) kept.push_back({v, 0, 0});
      }
      beyond.zone = derived(beyond.zone, kept);
      State passed = state;
      pass_cap(passed, machine_.watch(), static_cast<int>(o));
      if (grows(state, machine_.watch(), static_cast<int>(o))) never_answered_ = true;
      split(from, transition, std::move(passed), timers, frozen, std::move(beyond));
    }
    if (!made.zone.constrain(0, variable, cap_)) return;
  }
  const int place = place_of(std::move(state), std::move(timers), std::move(frozen));
  add(from, transition, place, std::move(made));
}

void ZoneGraph::add(int from, const Transition& transition, int place, ZoneClass made) {
  std::vector<int>& known = classes_of_[static_cast<std::size_t>(place)];
  const int number = static_cast<int>(classes_.size());
  for (int other : known) {
    const ZoneClass& there = classes_[static_cast<std::size_t>(other)];
    if (there.zone.includes(made.zone) && (!there.relaxed || made.relaxed)) {
      if (keep_edges_ && from >= 0) edges_.push_back({from, other, transition.timer});
      return;
    }
  }
  made.state = place;
  made.parent = from;
  made.timer = transition.timer;
  made.choices = transition.choices;
  std::erase_if(known, [&](int other) {
    ZoneClass& there = classes_[static_cast<std::size_t>(other)];
    if (!made.zone.includes(there.zone) || (made.relaxed && !there.relaxed)) return false;
    there.replaced_by = number;
    return true;
  });
  known.push_back(number);
  classes_.push_back(std::move(made));
  open_.push_back(number);
  if (keep_edges_ && from >= 0) edges_.push_back({from, number, transition.timer});
}

}  // namespace pal::analyzer
