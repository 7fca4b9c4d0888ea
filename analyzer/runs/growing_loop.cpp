#include "analyzer/runs/growing_loop.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "analyzer/machine/machine.hpp"
#include "analyzer/runs/simulate.hpp"
#include "analyzer/runs/snapshot.hpp"

namespace pal::analyzer {
namespace {

using Measure = Requirement::Measure;

/// A witness with more firings takes too long to be replayed and read.
constexpr std::size_t most_firings = 100'000;

/// Runs of so many events, so many of each. In short ones most loops are seen already.
struct Round {
  std::size_t events;
  std::uint64_t runs;
};
constexpr std::array<Round, 2> rounds{{{1'500, 8}, {12'000, 4}}};

/// SimulationOptions::seldom of one run after the other.
constexpr std::array<std::uint64_t, 4> seldom{16, 64, 4, 0};

/// A run beyond this, so that a chart of it can be read.
constexpr std::size_t most_shown = 3'000;
constexpr std::size_t most_confirmations = 12;  // a run

bool may_grow(const Problem& problem, const Requirement& requirement) {
  if (!fits_simulation(problem) || requirement.at_least) return false;
  switch (requirement.measure) {
    case Measure::load:
    case Measure::loss:
    case Measure::busy:
      return false;
    default:
      return true;
  }
}

/// In the script: everything is the same behind the firings `from` and `to`. The value that counts is
/// measured by firing `end`.
struct Stretch {
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t end = 0;
  Measurement measured;
};

/// The state behind each firing of a run, one by one.
class Player {
 public:
  Player(const Machine& machine, const std::vector<ScriptedFiring>& script)
      : script_(script), run_(machine, false) {
    go();
  }

  std::size_t at() const { return at_ - 1; }  // the last firing
  bool go() {
    if (at_ == script_.size()) return false;
    ScriptedChoices choices(script_[at_].choices);
    if (at_ == 0) {
      run_.begin(choices);
    } else if (!run_.fire(script_[at_].timer, script_[at_].at, choices)) {
      return false;
    }
    ++at_;
    return true;
  }
  bool go_to(std::size_t firing) {
    while (at() < firing) {
      if (!go()) return false;
    }
    return true;
  }
  const ConcreteRun& run() const { return run_; }
  const ScriptedFiring& next() const { return script_[at_]; }

 private:
  const std::vector<ScriptedFiring>& script_;
  ConcreteRun run_;
  std::size_t at_ = 0;
};

/// Which of the observers at one instant became which: by number now, the number then.
class Lineage {
 public:
  static constexpr int born_since = -1;

  explicit Lineage(std::size_t observers) : then_(observers) {
    for (std::size_t o = 0; o < observers; ++o) then_[o] = static_cast<int>(o);
  }
  int then(int now) const { return now < 0 ? born_since : then_[static_cast<std::size_t>(now)]; }
  void follow(const Outcome& outcome) {
    std::vector<int> next;
    for (const int before : outcome.origin) next.push_back(then(before));
    then_ = std::move(next);
  }

 private:
  std::vector<int> then_;
};

class Search {
 public:
  Search(const Problem& problem, const Requirement& requirement, const std::function<bool()>& stop)
      : problem_(problem), watch_(watch_of(problem, requirement)), machine_(problem, watch_), stop_(stop) {}

  std::optional<GrowingLoop> run() {
    for (const Round& round : rounds) {
      for (std::uint64_t number = 0; number < round.runs; ++number) {
        if (stop_ && stop_()) return std::nullopt;
        SimulationOptions how;
        how.times = number % 2 == 0 ? SimulationOptions::Times::worst : SimulationOptions::Times::best;
        how.seed = number + 1;
        how.seldom = seldom[number / 2 % seldom.size()];
        how.until = Range::unbounded / 2;
        how.max_events = round.events;
        how.stop = stop_;
        how.record = false;
        how.hash_states = true;
        if (auto found = in(simulate(machine_, how))) return found;
      }
    }
    return std::nullopt;
  }

 private:
  /// Stretches that look as if they could be repeated, the first ones first.
  static std::vector<Stretch> candidates(const Simulation& made) {
    std::vector<Stretch> found;
    std::unordered_map<std::size_t, std::size_t> met;
    std::size_t m = 0;  // of the measurements, the first behind this firing
    std::vector<std::size_t> behind;
    for (std::size_t k = 0; k < made.script.size(); ++k) {
      while (m < made.measured.size() && made.measured_after[m] <= k + 1) ++m;
      behind.push_back(m);
      if (m == made.measured.size()) break;
      const auto [place, is_new] = met.try_emplace(made.states[k], k);
      const std::size_t before = std::exchange(place->second, k);
      if (is_new) continue;
      const Measurement& first = made.measured[behind[before]];
      const bool same = first.born == made.measured[m].born && first.born <= made.script[before].at;
      if (!same || made.script[before].at == made.script[k].at) continue;
      found.push_back({before, k, made.measured_after[behind[before]] - 1, first});
      if (found.size() == most_confirmations) break;
    }
    return found;
  }

  std::optional<GrowingLoop> in(const Simulation& made) const {
    if (made.measured.empty()) return std::nullopt;
    for (const Stretch& stretch : candidates(made)) {
      if (!repeats(made.script, stretch)) continue;
      if (auto found = repeated(made.script, stretch)) return found;
    }
    return std::nullopt;
  }

  /// Whether the run may go through the stretch again and again, and what is measured at its end was watched
  /// since before.
  bool repeats(const std::vector<ScriptedFiring>& script, const Stretch& stretch) const {
    Player player(machine_, script);
    if (!player.go_to(stretch.from)) return false;
    const Snapshot before(player.run());
    Lineage lineage(player.run().births().size());
    int measured = Lineage::born_since;  // by its number before the stretch
    std::optional<Lineage> around;       // after one turn
    const auto same_value = [&](const Measurement& each) {
      return each.value == stretch.measured.value && each.at == stretch.measured.at;
    };
    while (player.at() < std::max(stretch.to, stretch.end)) {
      if (!player.go()) return false;
      const Outcome& outcome = player.run().outcome();
      if (player.at() == stretch.end) {
        const auto& all = player.run().measured();
        const std::size_t now = outcome.measured.size();
        for (std::size_t i = 0; i < now; ++i) {
          if (same_value(all[all.size() - now + i])) measured = lineage.then(outcome.measured[i]);
        }
      }
      lineage.follow(outcome);
      if (player.at() != stretch.to) continue;
      if (Snapshot(player.run()) != before) return false;
      around = lineage;
    }
    return measured != Lineage::born_since && around && around->then(measured) == measured;
  }

  std::vector<ScriptedFiring> script_with(const std::vector<ScriptedFiring>& script, const Stretch& stretch,
                                          std::size_t turns) const {
    const auto place = [&script](std::size_t k) { return script.begin() + static_cast<std::ptrdiff_t>(k); };
    const Nanoseconds length = script[stretch.to].at - script[stretch.from].at;
    std::vector<ScriptedFiring> made(script.begin(), place(stretch.from + 1));
    Nanoseconds later = 0;
    const auto add = [&](std::size_t last) {
      for (std::size_t k = stretch.from + 1; k <= last; ++k) {
        made.push_back(script[k]);
        made.back().at += later;
      }
    };
    for (std::size_t turn = 0; turn < turns; ++turn, later += length) add(stretch.to);
    add(stretch.end);
    return made;
  }

  std::optional<GrowingLoop> repeated(const std::vector<ScriptedFiring>& script,
                                      const Stretch& stretch) const {
    GrowingLoop made;
    made.stretch = script[stretch.to].at - script[stretch.from].at;
    const Nanoseconds missing = watch_.limit - stretch.measured.value;
    const std::size_t turns = missing < 0 ? 0 : static_cast<std::size_t>(missing / made.stretch) + 1;
    const std::size_t more = stretch.to - stretch.from;
    if (stretch.end + 1 > most_firings || turns > (most_firings - stretch.end - 1) / more)
      return std::nullopt;
    auto beyond = replay(machine_, script_with(script, stretch, turns));
    if (!beyond || beyond->grows || beyond->measured.value <= watch_.limit) return std::nullopt;
    auto first_turns = replay(machine_, beginning(script, stretch));
    if (!first_turns || first_turns->grows) return std::nullopt;
    made.beyond = std::move(*beyond);
    made.first_turns = std::move(*first_turns);
    made.loop = loop_of(script, stretch);
    return made;
  }

  /// The value is measured three times in it, if it is measured in each turn; else it is gone round twice
  /// more.
  std::vector<ScriptedFiring> beginning(const std::vector<ScriptedFiring>& script,
                                        const Stretch& stretch) const {
    std::vector<ScriptedFiring> longer = script_with(script, stretch, 2);
    if (longer.size() > most_shown) longer = script_with(script, stretch, 0);
    Player player(machine_, longer);
    std::size_t seen = 0;
    std::size_t times = 0;
    do {
      const auto& all = player.run().measured();
      bool measured = false;
      for (; seen < all.size(); ++seen) measured = measured || all[seen].born == stretch.measured.born;
      times += measured ? 1 : 0;
      if (times < 3) continue;
      longer.resize(player.at() + 1);
      break;
    } while (player.go());
    return longer;
  }

  /// The innermost loop that the thread stays in which measures, or if it waits all the time one of its
  /// blocks.
  LoopId loop_of(const std::vector<ScriptedFiring>& script, const Stretch& stretch) const {
    std::map<ThreadId, std::set<StepId>> visited;
    Player player(machine_, script);
    ThreadId measuring;
    while (player.at() < std::max(stretch.to, stretch.end)) {
      const bool inside = player.at() >= stretch.from && player.at() < stretch.to;
      const int timer = player.next().timer;
      const bool of_thread = timer >= 0 && machine_.is_of_thread(timer);
      if (of_thread && player.at() + 1 == stretch.end) measuring = machine_.thread_of(timer);
      if (of_thread && inside) {
        const ThreadId thread = machine_.thread_of(timer);
        visited[thread].insert(player.run().state().threads[thread].at());
      }
      if (!player.go()) return {};
    }
    for (ThreadId thread = measuring; thread.valid(); thread = problem_.threads[thread].parent) {
      if (const auto own = visited.find(thread); own != visited.end()) return loop_around(own->second);
    }
    for (const auto& [thread, steps] : visited) {
      for (ThreadId above = problem_.threads[thread].parent; above.valid();
           above = problem_.threads[above].parent) {
        if (above == measuring) return loop_around(steps);
      }
    }
    return {};
  }

  LoopId loop_around(const std::set<StepId>& steps) const {
    LoopId innermost;
    std::size_t least = problem_.steps.size() + 1;
    for (const LoopId l : problem_.loops.ids()) {
      const bool all =
          std::all_of(steps.begin(), steps.end(), [&](StepId s) { return is_in(problem_, s, l); });
      if (!all) continue;
      std::size_t size = 0;
      for (const StepId s : problem_.steps.ids()) size += is_in(problem_, s, l) ? 1 : 0;
      if (size >= least) continue;
      least = size;
      innermost = l;
    }
    return innermost;
  }

  const Problem& problem_;
  const Watch watch_;
  const Machine machine_;
  const std::function<bool()>& stop_;
};

/// Statements whose loop may be the phase: first those that renew what is known, then those that use it.
std::vector<StatementId> renewing(const Problem& problem, const Requirement& requirement) {
  std::vector<StatementId> setting, reading, using_it;
  const auto add = [](StatementId s, std::vector<StatementId>& to) {
    if (s.valid() && std::find(to.begin(), to.end(), s) == to.end()) to.push_back(s);
  };
  const bool known = requirement.measure == Measure::age || requirement.measure == Measure::reaction;
  std::set<pan::ModuleId> users;
  for (const StepId s : problem.steps.ids()) {
    const Step& step = problem.steps[s];
    if (!requirement.at[s]) continue;
    add(step.statement, using_it);
    if (step.statement.valid()) users.insert(problem.statements[step.statement].source_module);
  }
  for (const StepId s : problem.steps.ids()) {
    const Step& step = problem.steps[s];
    if (!known || !step.statement.valid()) continue;
    const bool of_condition = requirement.samples.empty() && step.condition == requirement.condition;
    if (of_condition && step.kind == Step::Kind::set) add(step.statement, setting);
    if (of_condition && step.kind == Step::Kind::read) add(step.statement, reading);
    const bool takes = step.kind == Step::Kind::wait && step.channels.size() == 1;
    if (!requirement.samples.empty() && takes &&
        users.contains(problem.statements[step.statement].source_module))
      add(step.statement, setting);
  }
  setting.insert(setting.end(), reading.begin(), reading.end());
  setting.insert(setting.end(), using_it.begin(), using_it.end());
  return setting;
}

}  // namespace

std::optional<GrowingLoop> find_growing_loop(const Problem& problem, const Requirement& requirement,
                                             const std::function<bool()>& stop) {
  if (!may_grow(problem, requirement)) return std::nullopt;
  return Search(problem, requirement, stop).run();
}

std::string phase_without(const Problem& problem, const Requirement& requirement, LoopId loop,
                          const std::function<bool()>& stop) {
  if (!loop.valid() || requirement.phase.limits() || requirement.measure == Measure::duration) return {};
  const ProgramLoop& left_out = problem.loops[loop];
  const auto has_left_out = [&](const ProgramLoop& each) {
    return each.module == left_out.module && each.repeat <= left_out.repeat && left_out.until <= each.until;
  };
  for (const StatementId statement : renewing(problem, requirement)) {
    const Statement& named = problem.statements[statement];
    // Like statements of the module are meant, too.
    std::set<LoopId> loops;
    bool every = true;
    for (const StepId s : problem.steps.ids()) {
      const StatementId other = problem.steps[s].statement;
      if (!other.valid() || problem.statements[other].text != named.text ||
          problem.statements[other].source_module != named.source_module)
        continue;
      const LoopId around = innermost_loop(problem, s);
      every = every && around.valid() && !has_left_out(problem.loops[around]);
      loops.insert(around);
    }
    if (!every) continue;
    Requirement limited = requirement;
    limited.phase.during.assign(problem.steps.size(), false);
    for (const StepId s : problem.steps.ids()) {
      for (const LoopId l : loops) limited.phase.during[s] = limited.phase.during[s] || is_in(problem, s, l);
    }
    if (find_growing_loop(problem, limited, stop)) continue;
    return "DURING REPEAT OF " + named.text + " IN " + named.module;
  }
  return {};
}

}  // namespace pal::analyzer
