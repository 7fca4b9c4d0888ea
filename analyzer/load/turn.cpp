#include "analyzer/load/turn.hpp"

#include <algorithm>
#include <deque>

namespace pal::analyzer {
namespace {

/// Times that keep bounds on their differences (R. Bellman, 1958).
class Differences {
 public:
  explicit Differences(std::size_t count) : from_(count) {}

  /// t[to] - t[from] <= bound.
  void add(std::size_t from, std::size_t to, Nanoseconds bound) {
    if (bound < Range::unbounded) from_[from].push_back({to, bound});
  }

  /// The greatest times with t[0] = 0; nothing, if there are none.
  std::optional<std::vector<Nanoseconds>> solve() const {
    std::vector<Nanoseconds> times(from_.size(), Range::unbounded);
    std::vector<std::size_t> improved(from_.size());
    std::vector<bool> queued(from_.size());
    std::deque<std::size_t> open{0};
    times[0] = 0;
    while (!open.empty()) {
      const std::size_t at = open.front();
      open.pop_front();
      queued[at] = false;
      for (const auto& [to, bound] : from_[at]) {
        if (times[at] + bound >= times[to]) continue;
        times[to] = times[at] + bound;
        if (++improved[to] > from_.size() || times[0] < 0) return std::nullopt;
        if (!queued[to]) open.push_back(to);
        queued[to] = true;
      }
    }
    return times;
  }

 private:
  std::vector<std::vector<std::pair<std::size_t, Nanoseconds>>> from_;
};

/// When a timer that is active was started, and with what range.
struct Life {
  bool active = false;
  std::size_t start = 0;  // firing
  Range range;
};

/// The stretch with its times as unknowns; those before it stay as they are.
class Turn {
 public:
  Turn(const Machine& machine, const std::vector<ScriptedFiring>& script, Stretch stretch, Nanoseconds period,
       ProcessorId processor)
      : machine_(machine),
        script_(script),
        stretch_(stretch),
        period_(period),
        processor_(processor),
        times_(stretch.end - stretch.begin + 1),
        lives_(static_cast<std::size_t>(machine.timer_count())) {}

  /// Times from the beginning of the stretch: of its firings, and of the last one before it.
  std::optional<std::vector<Nanoseconds>> solve() {
    ConcreteRun concrete_run(machine_, false);
    for (std::size_t k = 0; k <= stretch_.end; ++k) {
      ScriptedChoices choices(script_[k].choices);
      if (k == 0) {
        concrete_run.begin(choices);
      } else if (!concrete_run.fire(script_[k].timer, script_[k].at, choices)) {
        return std::nullopt;
      }
      if (k > stretch_.begin && !follow(k, concrete_run)) return std::nullopt;
      for (int started : concrete_run.started()) start(k, started, concrete_run);
    }
    if (!close()) return std::nullopt;
    return times_.solve();
  }

 private:
  std::size_t index(std::size_t firing) const { return firing - stretch_.begin; }

  void start(std::size_t k, int timer, const ConcreteRun& concrete_run) {
    Life& life = lives_[static_cast<std::size_t>(timer)];
    life = {true, k, concrete_run.timers()[static_cast<std::size_t>(timer)].range};
    if (k > stretch_.begin && machine_.processor_of(concrete_run.state(), timer) == processor_)
      life.range.best = life.range.worst;
  }

  /// What ends with firing `k`. False: something is interrupted.
  bool follow(std::size_t k, const ConcreteRun& concrete_run) {
    times_.add(index(k), index(k) - 1, 0);
    for (std::size_t t = 0; t < lives_.size(); ++t) {
      const ConcreteRun::Timer& timer = concrete_run.timers()[t];
      if (timer.active && timer.frozen) return false;
      Life& life = lives_[t];
      const bool fired = script_[k].timer == static_cast<int>(t);
      const bool restarted = std::find(concrete_run.started().begin(), concrete_run.started().end(),
                                       static_cast<int>(t)) != concrete_run.started().end();
      if (!life.active || (timer.active && !fired && !restarted)) continue;
      bound(k, life, fired);
      if (life.start <= stretch_.begin) ends_.push_back({t, k, fired});
      life.active = false;
    }
    return true;
  }

  void bound(std::size_t k, const Life& life, bool fired) {
    if (life.start > stretch_.begin) {
      limit(index(life.start), index(k), 0, life.range, fired);
    } else {
      // Begun before: from the beginning of the stretch on it has that much less left.
      limit(0, index(k), script_[stretch_.begin].at - script_[life.start].at, life.range, fired);
    }
  }

  /// A timer that was started `earlier` than `from` ends at `to`; if it did not fire it is stopped in time.
  void limit(std::size_t from, std::size_t to, Nanoseconds earlier, const Range& range, bool fired) {
    if (range.worst < Range::unbounded) times_.add(from, to, range.worst - earlier);
    if (fired) times_.add(to, from, earlier - range.best);
  }

  /// The end of the stretch is its beginning, a period later.
  bool close() {
    const std::size_t last = index(stretch_.end);
    times_.add(0, last, period_);
    times_.add(last, 0, -period_);
    for (const auto& [timer, end, fired] : ends_) {
      const Life& again = lives_[timer];
      if (!again.active) return false;
      limit(index(again.start), index(end), -period_, again.range, fired);
    }
    return true;
  }

  struct End {
    std::size_t timer;
    std::size_t firing;
    bool fired;
  };

  const Machine& machine_;
  const std::vector<ScriptedFiring>& script_;
  Stretch stretch_;
  Nanoseconds period_;
  ProcessorId processor_;
  Differences times_;
  std::vector<Life> lives_;
  std::vector<End> ends_;  // of what was active as the stretch began
};

/// Fires as scripted. False: a timer would fire too early, too late, or cannot.
bool fire(ConcreteRun& concrete_run, const ScriptedFiring& firing) {
  const std::vector<ConcreteRun::Timer>& timers = concrete_run.timers();
  for (std::size_t t = 0; t < timers.size(); ++t) {
    if (timers[t].active && !timers[t].frozen &&
        concrete_run.worked(static_cast<int>(t), firing.at) > timers[t].range.worst)
      return false;
  }
  const ConcreteRun::Timer& fired = timers[static_cast<std::size_t>(firing.timer)];
  if (!fired.active || fired.frozen || firing.at < concrete_run.now() ||
      concrete_run.worked(firing.timer, firing.at) < fired.range.best)
    return false;
  ScriptedChoices choices(firing.choices);
  return concrete_run.fire(firing.timer, firing.at, choices);
}

/// All that decides how a run can go on: its state, and what each timer has done.
struct Situation {
  State state;
  std::vector<Nanoseconds> worked;  // by timer; -1: not active

  explicit Situation(const ConcreteRun& concrete_run) : state(concrete_run.state()) {
    const std::vector<ConcreteRun::Timer>& timers = concrete_run.timers();
    for (std::size_t t = 0; t < timers.size(); ++t) {
      Nanoseconds done = timers[t].active ? concrete_run.worked(static_cast<int>(t), concrete_run.now()) : -1;
      // One that may wait as long as it likes only has to be able to fire.
      if (timers[t].range.worst >= Range::unbounded) done = std::min(done, timers[t].range.best);
      worked.push_back(done);
    }
  }

  friend bool operator==(const Situation&, const Situation&) = default;
};

/// Plays the stretch twice. If it ends both times in one situation, the second turn can be repeated for ever.
std::optional<UnendingRun> played_twice(const Machine& machine, std::vector<ScriptedFiring> script,
                                        Stretch stretch, Nanoseconds period, ProcessorId processor) {
  const std::size_t length = stretch.end - stretch.begin;
  for (std::size_t k = 1; k <= length; ++k) {
    ScriptedFiring firing = script[stretch.begin + k];
    firing.at += period;
    script.push_back(std::move(firing));
  }
  ConcreteRun concrete_run(machine, false);
  ScriptedChoices first(script.front().choices);
  concrete_run.begin(first);
  Nanoseconds busy = 0;
  std::optional<Situation> turned;
  for (std::size_t k = 1; k < script.size(); ++k) {
    if (k > stretch.end && concrete_run.state().running[processor] >= 0)
      busy += script[k].at - concrete_run.now();
    if (!fire(concrete_run, script[k])) return std::nullopt;
    if (k == stretch.end) turned = Situation(concrete_run);
  }
  if (!(Situation(concrete_run) == *turned)) return std::nullopt;
  auto witness = replay(machine, script);
  if (!witness) return std::nullopt;
  return UnendingRun{std::move(*witness), {busy, period}};
}

}  // namespace

std::optional<UnendingRun> repeat(const Machine& machine, std::vector<ScriptedFiring> script, Stretch stretch,
                                  Nanoseconds period, ProcessorId processor) {
  if (period <= 0 || stretch.end <= stretch.begin) return std::nullopt;
  script.resize(stretch.end + 1);
  if (script[stretch.end].at - script[stretch.begin].at == period) {
    if (auto made = played_twice(machine, script, stretch, period, processor)) return made;
  }
  const auto times = Turn(machine, script, stretch, period, processor).solve();
  if (!times) return std::nullopt;
  const Nanoseconds begin = script[stretch.begin].at;
  for (std::size_t k = stretch.begin + 1; k <= stretch.end; ++k)
    script[k].at = begin + (*times)[k - stretch.begin];
  return played_twice(machine, std::move(script), stretch, period, processor);
}

}  // namespace pal::analyzer
