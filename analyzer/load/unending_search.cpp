#include "analyzer/load/unending_search.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <unordered_map>
#include <unordered_set>

namespace pal::analyzer {
namespace {

constexpr std::uint64_t most_runs = 24;
constexpr std::size_t most_events = 1'500;
/// From where nothing leads on.
constexpr std::size_t most_detours = 64;
/// A state that was met before: how many of the last times are tried.
constexpr std::size_t most_returns = 24;
constexpr int most_tries = 3;  // a run and period
constexpr int most_tries_of_all = 120;

/// One run that stays in the recurrence once it is there.
class Wanderer {
 public:
  Wanderer(const Machine& machine, const std::unordered_set<State, StateHash>& inside, ProcessorId processor,
           std::uint64_t seed)
      : machine_(machine), inside_(inside), processor_(processor), manner_(seed % 4), engine_(seed) {}

  struct Visit {
    State state;
    Nanoseconds work = 0;         // that ended so far, at its worst
    Table<DeviceId, int> events;  // so far, of its own accord
  };

  /// False: the beginning leads somewhere else.
  bool begin(const std::vector<ScriptedFiring>& script) {
    script_ = script;
    first_ = script.size();
    if (!play() || !inside_.contains(concrete_run_->state())) return false;
    visits_.push_back({concrete_run_->state(), 0, Table<DeviceId, int>(machine_.problem().devices.size())});
    return true;
  }

  /// Where nothing leads on inside it goes back, the further the more often, and takes another way.
  void wander() {
    std::size_t back = 1;
    for (std::size_t n = 0; n < most_detours; ++n) {
      while (visits_.size() < most_events && go_on()) {
      }
      if (visits_.size() == most_events) return;
      back = n % 8 == 7 ? 1 : 2 * back;
      visits_.resize(visits_.size() - std::min(visits_.size() - 1, back + engine_() % back));
      script_.resize(first_ + visits_.size() - 1);
      if (!play()) return;
    }
  }

  const std::vector<ScriptedFiring>& script() const { return script_; }
  /// One a firing, from the last of the beginning on.
  const std::vector<Visit>& visits() const { return visits_; }

 private:
  /// From the start to the end of the script; what is under way then may end at other times than before.
  bool play() {
    concrete_run_.emplace(machine_, false);
    for (std::size_t k = 0; k < script_.size(); ++k) {
      ScriptedChoices choices(script_[k].choices);
      if (k == 0) {
        concrete_run_->begin(choices);
      } else if (!concrete_run_->fire(script_[k].timer, script_[k].at, choices)) {
        return false;
      }
    }
    for (std::size_t t = 0; t < concrete_run_->timers().size(); ++t) {
      if (concrete_run_->timers()[t].active) draw(static_cast<int>(t));
    }
    return true;
  }

  /// False: it cannot go on. What may wait as long as it likes, and would lead outside, does not come.
  bool go_on() {
    for (;;) {
      const std::vector<int> first = next();
      if (first.empty()) return false;
      if (std::any_of(first.begin(), first.end(), [&](int timer) { return fire(timer, due(timer)); }))
        return true;
      bool put_off = false;
      for (const int t : first) {
        ConcreteRun::Timer& timer = concrete_run_->timers()[static_cast<std::size_t>(t)];
        if (timer.range.worst < Range::unbounded) continue;
        timer.duration = Range::unbounded;
        put_off = true;
      }
      if (!put_off) return false;
    }
  }

  Nanoseconds left(int index) const {
    return concrete_run_->timers()[static_cast<std::size_t>(index)].duration -
           concrete_run_->worked(index, concrete_run_->now());
  }
  Nanoseconds due(int index) const { return concrete_run_->now() + left(index); }

  /// The timers that may fire first, in any order; empty: none ever does.
  std::vector<int> next() {
    std::vector<int> first;
    Nanoseconds least = Range::unbounded;
    for (std::size_t t = 0; t < concrete_run_->timers().size(); ++t) {
      const ConcreteRun::Timer& timer = concrete_run_->timers()[t];
      if (!timer.active || timer.frozen || timer.duration >= Range::unbounded) continue;
      const Nanoseconds its = left(static_cast<int>(t));
      if (its < least) first.clear();
      if (its <= least) first.push_back(static_cast<int>(t));
      least = std::min(least, its);
    }
    std::shuffle(first.begin(), first.end(), engine_);
    return first;
  }

  bool fire(int timer, Nanoseconds at) {
    std::vector<std::vector<std::uint8_t>> ways;
    AllChoices all;
    do {
      Outcome outcome;
      if (!machine_.fire(concrete_run_->state(), timer, all, false, outcome)) return false;
      if (inside_.contains(outcome.state)) ways.push_back(all.taken());
    } while (all.next());
    if (ways.empty()) return false;
    const std::vector<std::uint8_t>& way = ways[engine_() % ways.size()];
    const bool ours = machine_.processor_of(concrete_run_->state(), timer) == processor_;
    const Nanoseconds work = ours ? machine_.cost(concrete_run_->state(), timer).worst : 0;
    ScriptedChoices choices(way);
    concrete_run_->fire(timer, at, choices);
    script_.push_back({timer, way, at});
    for (int started : concrete_run_->started()) draw(started);
    Visit visit{concrete_run_->state(), visits_.back().work + work, visits_.back().events};
    for (const DeviceId d : visit.events.ids()) visit.events[d] += timer == machine_.next_timer(d) ? 1 : 0;
    visits_.push_back(std::move(visit));
    return true;
  }

  /// The processor's own actions are as long as they may be; other times are short, long, or either.
  void draw(int index) {
    ConcreteRun::Timer& timer = concrete_run_->timers()[static_cast<std::size_t>(index)];
    const Nanoseconds worked = concrete_run_->worked(index, concrete_run_->now());
    const bool ours = machine_.processor_of(concrete_run_->state(), index) == processor_;
    const bool longest = ours || manner_ == 1 || (manner_ > 1 && engine_() % 2 == 0);
    timer.duration = longest && timer.range.worst < Range::unbounded ? timer.range.worst : timer.range.best;
    timer.duration = std::max(timer.duration, worked);
  }

  const Machine& machine_;
  const std::unordered_set<State, StateHash>& inside_;
  ProcessorId processor_;
  std::uint64_t manner_;
  std::mt19937_64 engine_;
  std::optional<ConcreteRun> concrete_run_;
  std::vector<ScriptedFiring> script_;
  std::size_t first_ = 0;  // firings of the beginning
  std::vector<Visit> visits_;
};

/// Periods of devices that keep one of their own; 0: of none.
Table<DeviceId, Nanoseconds> periods(const Problem& problem) {
  Table<DeviceId, Nanoseconds> all;
  for (const Device& device : problem.devices) {
    Nanoseconds each = 0;
    if (const auto* event = std::get_if<pan::EventDevice>(&device.behaviour)) {
      if (!event->sporadic) each = event->period.count();
    } else if (const auto* frames = std::get_if<pan::FrameDevice>(&device.behaviour)) {
      each = frames->period.count();
    }
    all.push_back(each);
  }
  return all;
}

/// The time that the periodic devices need for as many periods as between the two visits. Without such
/// devices: `usual`. 0: they cannot all come back together.
Nanoseconds period_of(const Table<DeviceId, Nanoseconds>& periods, const Wanderer::Visit& from,
                      const Wanderer::Visit& to, Nanoseconds usual) {
  std::optional<Nanoseconds> period;
  for (const DeviceId d : periods.ids()) {
    if (periods[d] == 0 || !from.state.devices[d].open) continue;
    const Nanoseconds its = periods[d] * (to.events[d] - from.events[d]);
    if (period && *period != its) return 0;
    period = its;
  }
  return period.value_or(usual);
}

struct Candidate {
  Stretch stretch;
  Nanoseconds period = 0;
  Nanoseconds off = 0;  // by how much the run itself missed the period
  Fraction load;
};

/// Stretches that begin and end in one state, those with the greatest load first, and those first that
/// nearly come back by themselves.
std::vector<Candidate> candidates(const Machine& machine, const Wanderer& run) {
  std::vector<Candidate> found;
  std::unordered_map<State, std::vector<std::size_t>, StateHash> met;
  const Table<DeviceId, Nanoseconds> own = periods(machine.problem());
  const std::size_t before = run.script().size() - run.visits().size();
  for (std::size_t v = 0; v < run.visits().size(); ++v) {
    std::vector<std::size_t>& earlier = met[run.visits()[v].state];
    for (std::size_t n = earlier.size(); n-- > 0 && earlier.size() - n <= most_returns;) {
      const Stretch stretch{before + earlier[n], before + v};
      const Wanderer::Visit& from = run.visits()[earlier[n]];
      const Wanderer::Visit& to = run.visits()[v];
      const Nanoseconds passed = run.script()[stretch.end].at - run.script()[stretch.begin].at;
      const Nanoseconds period = period_of(own, from, to, passed);
      const Nanoseconds work = to.work - from.work;
      if (period > 0 && work > 0 && work <= period)
        found.push_back({stretch, period, std::abs(passed - period), {work, period}});
    }
    earlier.push_back(v);
  }
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    if (greater(a.load, b.load) || greater(b.load, a.load)) return greater(a.load, b.load);
    return a.off < b.off;
  });
  return found;
}

}  // namespace

std::optional<UnendingRun> search_unending(const Machine& machine, const ZoneGraph& graph,
                                           const Recurrence& recurrence, ProcessorId processor,
                                           const std::function<bool(const Fraction&)>& enough,
                                           const std::function<bool()>& stop) {
  std::unordered_set<State, StateHash> inside;
  for (int c : recurrence.classes) {
    const ZoneClass& of = graph.classes()[static_cast<std::size_t>(c)];
    inside.insert(graph.places()[static_cast<std::size_t>(of.state)].state);
  }
  std::optional<UnendingRun> best;
  int all_tries = 0;
  for (std::uint64_t seed = 0; seed < most_runs && !recurrence.entries.empty() && !(stop && stop()); ++seed) {
    const int entry = recurrence.entries[seed / 4 % recurrence.entries.size()];
    const auto beginning = script_to(machine, graph, entry, {});
    if (!beginning) continue;
    Wanderer run(machine, inside, processor, seed);
    if (!run.begin(*beginning)) continue;
    run.wander();
    std::map<Nanoseconds, int> tries;  // by period
    for (const Candidate& each : candidates(machine, run)) {
      if (best && !greater(each.load, best->load)) break;
      if (tries[each.period]++ >= most_tries) continue;
      if (++all_tries > most_tries_of_all) return best;
      auto made = repeat(machine, run.script(), each.stretch, each.period, processor);
      if (!made || (best && !greater(made->load, best->load))) continue;
      best = std::move(made);
      if (enough(best->load)) return best;
    }
  }
  return best;
}

}  // namespace pal::analyzer
