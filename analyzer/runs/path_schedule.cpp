#include "analyzer/runs/path_schedule.hpp"

#include <algorithm>

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

}  // namespace

PathSchedule::PathSchedule(const Machine& machine, const std::vector<ScriptedFiring>& path, Pin pin,
                           int growing)
    : machine_(machine),
      concrete_run_(machine, false),
      lives_(static_cast<std::size_t>(machine.timer_count())),
      pin_(pin),
      growing_(growing) {
  feasible_ = build(path);
}

std::optional<std::vector<Nanoseconds>> PathSchedule::solve(Aim aim, Nanoseconds enough,
                                                            const std::function<bool()>& stop,
                                                            bool less_will_not_do) const {
  if (pin_ != Pin::open) return by_differences(aim, enough, stop);
  std::optional<Goal> goal = goal_of(aim, enough);
  if (goal) goal->less_will_not_do = less_will_not_do;
  return linear_times(count_, constraints_, works_, goal, stop);
}

std::optional<std::vector<Nanoseconds>> PathSchedule::by_differences(
    Aim aim, Nanoseconds enough, const std::function<bool()>& stop) const {
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

void PathSchedule::leave(int timer, Nanoseconds left) {
  const Life& life = lives_[static_cast<std::size_t>(timer)];
  if (!life.active || life.frozen) {
    feasible_ = false;
    return;
  }
  const Nanoseconds most = life.range.worst >= none ? none : life.range.worst + life.owed - left;
  between(life.started, count_ - 1, life.range.best + life.owed - left, most);
}

std::optional<Goal> PathSchedule::goal_of(Aim aim, Nanoseconds enough) const {
  if (aim == Aim::any || births_at_end_.empty()) return std::nullopt;
  const std::size_t born = births_at_end_.front();
  if (aim == Aim::least) return Goal{count_ - 1, born, enough < none ? -enough : none};
  return Goal{born, count_ - 1, enough};
}

/// A life that was interrupted: what it has worked in all, up to event `until`.
void PathSchedule::worked(Life life, std::size_t until, bool over) {
  if (!life.frozen) life.pieces.emplace_back(life.resumed, until);
  works_.push_back({life.pieces, {over ? life.range.best : 0, life.range.worst}});
}

void PathSchedule::between(std::size_t from, std::size_t to, Nanoseconds least, Nanoseconds most) {
  constraints_.push_back({to, from, -least});
  if (most < none) constraints_.push_back({from, to, most});
}

bool PathSchedule::build(const std::vector<ScriptedFiring>& path) {
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
      for (int origin : growing_ == no_growth
                            ? outcome.measured
                            : std::vector<int>{outcome.origin[static_cast<std::size_t>(growing_)]})
        births_at_end_.push_back(origin < 0 ? k : births[static_cast<std::size_t>(origin)]);
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
bool PathSchedule::find_oldest() {
  const int observers = concrete_run_.state().observers;
  for (growing_ = 0; growing_ < observers; ++growing_) {
    if (grows(concrete_run_.state(), machine_.watch(), growing_)) return true;
  }
  return false;
}

void PathSchedule::still_open(const Life& life, std::size_t until) {
  if (pin_ == Pin::open && !life.pieces.empty()) return worked(life, until, false);
  if (life.range.worst < none) constraints_.push_back({life.started, until, life.range.worst + life.owed});
}

/// An action ends: the ones that it preempted are owed its time, which is fixed for that purpose.
void PathSchedule::pay(ProcessorId processor, int timer, Range& range) {
  if (pin_ == Pin::open) return;
  for (const ThreadId t : machine_.problem().threads.ids()) {
    Life& life = lives_[t.index()];
    if (machine_.thread_timer(t) == timer || !life.active || !life.frozen) continue;
    if (machine_.problem().threads[t].processor != processor) continue;
    pinned_ = pinned_ || range.best != range.worst;
    if (range.best != range.worst) range.best = range.worst = pin_ == Pin::worst ? range.worst : range.best;
    life.owed += range.best;
  }
}

void PathSchedule::apply_changes(std::size_t k) {
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

}  // namespace pal::analyzer
