#include "analyzer/runs/witness.hpp"

#include <algorithm>

#include "analyzer/runs/linear_times.hpp"

namespace pal::analyzer {
namespace {

using Constraint = Difference;

constexpr Nanoseconds none = Range::unbounded;
constexpr std::size_t usual_rounds = 50;

/// Shortest distances from `source`; nothing if the constraints contradict one another. They come in the
/// order of the events, mostly: to and fro (J. Y. Yen, An algorithm for finding shortest routes from all
/// source nodes to a given destination in general networks, 1970) few rounds suffice.
/// Where they do contradict one another each round makes the way back to the source shorter, or goes on until
/// it is told to stop. When time is up what is known is still told: the usual number of rounds is made then,
/// too.
std::optional<std::vector<Nanoseconds>> distances(const std::vector<Constraint>& constraints,
                                                  std::size_t count, std::size_t source,
                                                  const std::function<bool()>& stop) {
  std::vector<Nanoseconds> distance(count, none);
  distance[source] = 0;
  for (std::size_t round = 0; round <= count; ++round) {
    bool changed = false;
    const auto keep = [&](const Constraint& c) {
      if (distance[c.from] >= none || c.bound >= none) return;
      if (distance[c.from] + c.bound >= distance[c.to]) return;
      distance[c.to] = distance[c.from] + c.bound;
      changed = true;
    };
    std::for_each(constraints.begin(), constraints.end(), keep);
    std::for_each(constraints.rbegin(), constraints.rend(), keep);
    if (!changed) return distance;
    if (distance[source] < 0 || (round >= usual_rounds && stop && stop())) return std::nullopt;
  }
  return std::nullopt;
}

/// The path as constraints on the times of its events.
class Schedule {
 public:
  /// How long an action takes that preempts others and whose time is not fixed: any time within its interval
  /// (open), or one that makes differences of all constraints.
  enum class Pin { open, worst, best };

  /// `growing`: the observer after the last event whose value is in question; -1: what the last event
  /// measures.
  Schedule(const Machine& machine, const std::vector<ScriptedFiring>& path, Pin pin, int growing = no_growth)
      : machine_(machine),
        concrete_run_(machine, false),
        lives_(static_cast<std::size_t>(machine.timer_count())),
        pin_(pin),
        growing_(growing) {
    feasible_ = build(path);
  }

  bool feasible() const { return feasible_; }
  /// Times were fixed: another pin may give other ones.
  bool pinned() const { return pinned_; }

  enum class Aim { any, greatest, least };

  /// Times of all events such that what was measured at the last is as great, or as small, as it can be;
  /// nothing if impossible. A value that can grow without end is made as great as `enough`; one that cannot
  /// is never beyond it.
  std::optional<std::vector<Nanoseconds>> solve(Aim aim, Nanoseconds enough = none,
                                                const std::function<bool()>& stop = {}) {
    if (pin_ == Pin::open) return linear_times(count_, constraints_, works_, goal_of(aim, enough), stop);
    std::vector<Constraint> constraints = constraints_;
    if (aim == Aim::greatest) {
      if (births_at_end_.empty()) return std::nullopt;
      std::optional<Constraint> best;
      for (std::size_t born : births_at_end_) {
        const auto distance = distances(constraints, count_, born, stop);
        if (!distance) return std::nullopt;
        const Nanoseconds most = std::min((*distance)[count_ - 1], enough);
        if (most >= none) return std::nullopt;
        if (!best || most > -best->bound) best = Constraint{count_ - 1, born, -most};
      }
      constraints.push_back(*best);
    }
    if (aim == Aim::least) {
      const auto distance = distances(constraints, count_, count_ - 1, stop);
      if (!distance || births_at_end_.empty()) return std::nullopt;
      const std::size_t born = births_at_end_.front();
      constraints.push_back({born, count_ - 1, -(*distance)[born]});
    }
    // As early as can be: longest paths from the start, which are shortest ones backwards.
    std::vector<Constraint> reversed;
    for (const Constraint& c : constraints) reversed.push_back({c.to, c.from, c.bound});
    const auto distance = distances(reversed, count_, 0, stop);
    if (!distance) return std::nullopt;
    std::vector<Nanoseconds> times;
    for (Nanoseconds d : *distance) times.push_back(-d);
    return times;
  }

  /// At the end `timer` has `left` to go.
  void leave(int timer, Nanoseconds left) {
    const Life& life = lives_[static_cast<std::size_t>(timer)];
    if (!life.active || life.frozen) {
      feasible_ = false;
      return;
    }
    const Nanoseconds most = life.range.worst >= none ? none : life.range.worst + life.owed - left;
    between(life.started, count_ - 1, life.range.best + life.owed - left, most);
  }

 private:
  struct Life {
    bool active = false;
    std::size_t started = 0;
    Range range;
    Nanoseconds owed = 0;  // processor time that others had while this one was frozen
    bool frozen = false;
    std::size_t froze = 0;
    std::size_t resumed = 0;
    std::vector<std::pair<std::size_t, std::size_t>> pieces;  // that are over
  };

  std::optional<Goal> goal_of(Aim aim, Nanoseconds enough) const {
    if (aim == Aim::any || births_at_end_.empty()) return std::nullopt;
    const std::size_t born = births_at_end_.front();
    if (aim == Aim::least) return Goal{count_ - 1, born, enough < none ? -enough : none};
    return Goal{born, count_ - 1, enough};
  }

  /// A life that was interrupted: what it has worked in all, up to event `until`.
  void worked(Life life, std::size_t until, bool over) {
    if (!life.frozen) life.pieces.emplace_back(life.resumed, until);
    works_.push_back({life.pieces, {over ? life.range.best : 0, life.range.worst}});
  }

  void between(std::size_t from, std::size_t to, Nanoseconds least, Nanoseconds most) {
    constraints_.push_back({to, from, -least});
    if (most < none) constraints_.push_back({from, to, most});
  }

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  bool build(const std::vector<ScriptedFiring>& path) {
    std::vector<std::size_t> births;
    for (std::size_t k = 0; k < path.size(); ++k) {
      ScriptedChoices choices(path[k].choices);
      const int timer = path[k].timer;
      if (k == 0) {
        concrete_run_.begin(choices);
      } else {
        between(k - 1, k, 0, none);
        const State before = concrete_run_.state();
        Life& life = lives_[static_cast<std::size_t>(timer)];
        if (!life.active || life.frozen) return false;
        Range range{life.range.best, life.range.worst};
        const ProcessorId processor = machine_.processor_of(before, timer);
        if (pin_ == Pin::open && !life.pieces.empty()) {
          worked(life, k, true);
        } else {
          if (processor.valid()) pay(processor, timer, range);
          between(life.started, k, range.best + life.owed,
                  range.worst >= none ? none : range.worst + life.owed);
        }
        life = {};
        if (!concrete_run_.fire(timer, 0, choices)) return false;
      }
      apply_changes(k);
      const Outcome& outcome = concrete_run_.outcome();
      if (k + 1 == path.size()) {
        if (growing_ == oldest_growth && !find_oldest()) return false;
        for (int origin :
             growing_ == no_growth ? outcome.measured : std::vector<int>{outcome.origin[at(growing_)]})
          births_at_end_.push_back(origin < 0 ? k : births[at(origin)]);
      }
      std::vector<std::size_t> next;
      for (int origin : outcome.origin)
        next.push_back(origin < 0 ? k : births[static_cast<std::size_t>(origin)]);
      births = std::move(next);
    }
    count_ = path.size();
    for (const Life& life : lives_) {
      if (life.active) still_open(life, life.frozen ? life.froze : count_ - 1);
    }
    return true;
  }

  /// The first of the values that grow at the end.
  bool find_oldest() {
    const int observers = concrete_run_.state().observers;
    for (growing_ = 0; growing_ < observers; ++growing_) {
      if (grows(concrete_run_.state(), machine_.watch(), growing_)) return true;
    }
    return false;
  }

  void still_open(const Life& life, std::size_t until) {
    if (pin_ == Pin::open && !life.pieces.empty()) return worked(life, until, false);
    if (life.range.worst < none) constraints_.push_back({life.started, until, life.range.worst + life.owed});
  }

  /// An action ends: the ones that it preempted are owed its time, which is fixed for that purpose.
  void pay(ProcessorId processor, int timer, Range& range) {
    if (pin_ == Pin::open) return;
    for (std::size_t t = 0; t < machine_.problem().threads.size(); ++t) {
      if (static_cast<int>(t) == timer || !lives_[t].active || !lives_[t].frozen) continue;
      if (machine_.problem().threads[t].processor != processor) continue;
      pinned_ = pinned_ || range.best != range.worst;
      if (range.best != range.worst) range.best = range.worst = pin_ == Pin::worst ? range.worst : range.best;
      lives_[t].owed += range.best;
    }
  }

  void apply_changes(std::size_t k) {
    for (const TimerChange& change : concrete_run_.outcome().changes) {
      Life& life = lives_[static_cast<std::size_t>(change.timer)];
      switch (change.kind) {
        case TimerChange::Kind::start:
          life = {true, k, change.range, 0, false, 0, k, {}};
          break;
        case TimerChange::Kind::stop:
          still_open(life, k);
          life = {};
          break;
        case TimerChange::Kind::freeze:
          still_open(life, k);
          life.frozen = true;
          life.froze = k;
          life.pieces.emplace_back(life.resumed, k);
          break;
        case TimerChange::Kind::resume:
          life.frozen = false;
          life.resumed = k;
          break;
      }
    }
  }

  const Machine& machine_;
  ConcreteRun concrete_run_;
  std::vector<Life> lives_;
  Pin pin_;
  int growing_;
  std::vector<Constraint> constraints_;
  std::vector<Work> works_;  // without pins: of what was interrupted
  std::vector<std::size_t> births_at_end_;
  std::size_t count_ = 0;
  bool feasible_ = false;
  bool pinned_ = false;
};

std::vector<ScriptedFiring> path_to(const ZoneGraph& graph, const Peak& peak) {
  std::vector<ScriptedFiring> path{{peak.timer, peak.choices, 0}};
  for (int at = peak.parent; at >= 0;) {
    const ZoneClass& of = graph.classes()[static_cast<std::size_t>(at)];
    const Move& move = graph.move_to(of);
    path.push_back({move.timer, move.choices, 0});
    at = of.parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<ScriptedFiring> path_to(const ZoneGraph& graph, int target) {
  const ZoneClass& of = graph.classes()[static_cast<std::size_t>(target)];
  Peak last;
  last.parent = of.parent;
  last.timer = graph.move_to(of).timer;
  last.choices = graph.move_to(of).choices;
  return path_to(graph, last);
}

}  // namespace

std::optional<std::vector<ScriptedFiring>> script_to(const Machine& machine, const ZoneGraph& graph,
                                                     int target,
                                                     const std::vector<std::pair<int, Nanoseconds>>& left) {
  std::vector<ScriptedFiring> path = path_to(graph, target);
  Schedule schedule(machine, path, Schedule::Pin::worst);
  for (const auto& [timer, time] : left) schedule.leave(timer, time);
  if (!schedule.feasible()) return std::nullopt;
  const auto times = schedule.solve(Schedule::Aim::any);
  if (!times) return std::nullopt;
  for (std::size_t k = 0; k < path.size(); ++k) path[k].at = (*times)[k];
  return path;
}

std::optional<Witness> replay(const Machine& machine, const std::vector<ScriptedFiring>& script,
                              bool growing) {
  ConcreteRun concrete_run(machine);
  for (std::size_t k = 0; k < script.size(); ++k) {
    ScriptedChoices choices(script[k].choices);
    if (k == 0) {
      concrete_run.begin(choices);
      continue;
    }
    const Nanoseconds at = script[k].at;
    if (at < concrete_run.now()) return std::nullopt;
    const auto& timers = concrete_run.timers();
    for (std::size_t t = 0; t < timers.size(); ++t) {
      if (!timers[t].active || timers[t].frozen) continue;
      if (concrete_run.worked(static_cast<int>(t), at) > timers[t].range.worst) return std::nullopt;
    }
    const auto& fired = timers[static_cast<std::size_t>(script[k].timer)];
    if (!fired.active || fired.frozen || concrete_run.worked(script[k].timer, at) < fired.range.best)
      return std::nullopt;
    if (!concrete_run.fire(script[k].timer, at, choices)) return std::nullopt;
  }
  Witness witness;
  witness.script = script;
  witness.trace = concrete_run.trace();
  witness.failed = concrete_run.state().failed;
  const auto& left = concrete_run.timers();
  witness.still = std::none_of(left.begin(), left.end(),
                               [](const ConcreteRun::Timer& timer) { return timer.active && !timer.frozen; });
  const bool least = machine.watch().least;
  bool any = false;
  for (const Measurement& made : concrete_run.measured()) {
    if (growing || made.at != concrete_run.now()) continue;
    if (!any || (least ? made.value <= witness.measured.value : made.value >= witness.measured.value)) {
      witness.measured = made;
    }
    any = true;
  }
  // What still grows counts from the first of the instants that do.
  for (std::size_t o = 0; o < concrete_run.births().size() && !any; ++o) {
    if (!grows(concrete_run.state(), machine.watch(), static_cast<int>(o))) continue;
    const Nanoseconds born = concrete_run.births()[o];
    witness.measured = {concrete_run.now() - born, born, concrete_run.now(), -1};
    witness.grows = true;
    break;
  }
  return witness;
}

std::optional<Witness> stuck_witness(const Machine& machine, const ZoneGraph& graph, int stuck,
                                     Nanoseconds value) {
  const auto script = script_to(machine, graph, stuck, {});
  std::optional<Witness> made;
  if (script) made = replay(machine, *script, true);
  if (!made || !made->grows) return std::nullopt;
  made->measured.value = std::max(made->measured.value, value);
  made->measured.at = made->measured.born + made->measured.value;
  return made;
}

std::optional<Witness> grown_witness(const Machine& machine, const ZoneGraph& graph, int target,
                                     const std::function<bool()>& stop) {
  return witness_along(machine, path_to(graph, target), true, oldest_growth, false, stop);
}

std::optional<Witness> witness_along(const Machine& machine, std::vector<ScriptedFiring> path, bool measured,
                                     int growing, bool quick, const std::function<bool()>& stop,
                                     std::optional<Nanoseconds> known) {
  const Watch& watch = machine.watch();
  const bool timed = measured && watch.kind != Watch::Kind::loss;
  const Schedule::Aim aim = !timed        ? Schedule::Aim::any
                            : watch.least ? Schedule::Aim::least
                                          : Schedule::Aim::greatest;
  std::optional<Witness> best;
  // With times fixed where preemption makes sums of them; if there are such, with what all can be at once.
  for (const Schedule::Pin pin : {Schedule::Pin::worst, Schedule::Pin::open, Schedule::Pin::best}) {
    Schedule schedule(machine, path, pin, growing);
    if (!schedule.feasible()) continue;
    const auto times =
        schedule.solve(aim, growing != no_growth ? watch.limit + 1 : known.value_or(none), stop);
    if (!times) continue;
    for (std::size_t k = 0; k < path.size(); ++k) path[k].at = (*times)[k];
    std::optional<Witness> made = replay(machine, path, growing != no_growth);
    if (!made) continue;
    const bool better = !best || (watch.least ? made->measured.value < best->measured.value
                                              : made->measured.value > best->measured.value);
    if (better) best = std::move(made);
    if (!schedule.pinned() || quick || (known && best->measured.value == *known)) break;
  }
  return best;
}

std::optional<Witness> witness_of(const Machine& machine, const ZoneGraph& graph, const Peak& peak,
                                  bool quick, const std::function<bool()>& stop) {
  const std::optional<Nanoseconds> known =
      peak.value >= 0 && !peak.grows ? std::optional(peak.value) : std::nullopt;
  return witness_along(machine, path_to(graph, peak), peak.value >= 0, peak.grows ? peak.measured : no_growth,
                       quick, stop, known);
}

}  // namespace pal::analyzer
