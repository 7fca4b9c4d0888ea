// What must hold of the analysis of every skill.
#include <catch2/catch.hpp>
#include <iostream>

#include "analyzer/exact/exact.hpp"
#include "analyzer/load/load.hpp"
#include "analyzer/load/share_bound.hpp"
#include "analyzer/load/unending_search.hpp"
#include "analyzer/runs/simulate.hpp"
#include "pal/trace/slices.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

constexpr Nanoseconds millisecond = 1'000'000;

/// A skill that the checker accepts.
std::unique_ptr<test::Skill> accepted(std::uint64_t seed, int longest, std::string& text) {
  text = test::RandomSkill(seed, longest).text();
  auto skill = test::skill_from_text(text);
  if (!skill->problem) skill.reset();
  return skill;
}

void expect_run(const Requirement& requirement, const Verdict& verdict, const Simulation& run) {
  if (run.failed) {
    CHECK(verdict.state != Verdict::State::holds);
    CHECK_FALSE(verdict.bound);
  }
  if (!run.measured.empty()) CHECK(verdict.state != Verdict::State::never);
  for (const Measurement& measured : run.measured) {
    if (requirement.at_least) {
      if (verdict.bound) CHECK(measured.value >= verdict.bound->count());
      if (measured.value < requirement.limit) CHECK(verdict.state != Verdict::State::holds);
      continue;
    }
    if (verdict.bound) CHECK(measured.value <= verdict.bound->count());
    if (measured.value > requirement.limit) CHECK(verdict.state != Verdict::State::holds);
  }
  if (verdict.bound) CHECK(run.grown <= verdict.bound->count());
  if (run.grown > requirement.limit) CHECK(verdict.state != Verdict::State::holds);
}

/// One for each processor of a busy period, else one.
std::vector<Watch> watches_of(const Problem& problem, const Requirement& requirement) {
  if (requirement.measure != Requirement::Measure::busy) return {watch_of(problem, requirement)};
  std::vector<Watch> watches;
  for (const ProcessorId processor : requirement.processors)
    watches.push_back(watch_of(problem, requirement, processor));
  return watches;
}

}  // namespace

TEST_CASE("no simulated run exceeds what was proved") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 10);
  std::size_t decided = 0;
  std::size_t exact = 0;
  std::size_t timed = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    std::string text;
    const auto skill = accepted(seed, 9, text);
    if (!skill) continue;
    INFO("seed " << seed << "\n" << text);
    const Problem& problem = *skill->problem;
    Options options;
    options.max_states = 8'000;
    const Analysis analysis = analyze_exactly(problem, options);
    for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
      const Requirement& requirement = problem.requirements[r];
      if (requirement.measure == Requirement::Measure::load) continue;
      const Verdict& verdict = analysis.verdicts[r];
      ++timed;
      decided += verdict.state != Verdict::State::undecided ? 1 : 0;
      exact += verdict.exact ? 1 : 0;
      for (const Watch& watch : watches_of(problem, requirement)) {
        const Machine machine(problem, watch);
        for (const auto times : {SimulationOptions::Times::worst, SimulationOptions::Times::best,
                                 SimulationOptions::Times::random, SimulationOptions::Times::extremes}) {
          for (std::uint64_t run = 0; run < 6; ++run) {
            SimulationOptions simulation;
            simulation.times = times;
            simulation.seed = seed * 100 + run;
            simulation.until = 400 * millisecond;
            simulation.max_events = 4'000;
            simulation.record = false;
            INFO(requirement.name << " run " << run << ": " << verdict.explanation.text());
            expect_run(requirement, verdict, simulate(machine, simulation));
          }
        }
      }
    }
  }
  std::cout << "of " << timed << " requirements " << decided << " decided, " << exact << " exactly\n";
  CHECK(timed > 0);
}

TEST_CASE("the bound is what trying every run gives") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 10);
  std::size_t compared = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    std::string text;
    const auto skill = accepted(seed, 4, text);
    if (!skill) continue;
    INFO("seed " << seed << "\n" << text);
    const Problem& problem = *skill->problem;
    if (text.find("SPORADIC") != std::string::npos) continue;
    Options options;
    options.max_states = 8'000;
    const Analysis analysis = analyze_exactly(problem, options);
    for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
      const Requirement& requirement = problem.requirements[r];
      if (requirement.measure == Requirement::Measure::load) continue;
      const Verdict& verdict = analysis.verdicts[r];
      const Nanoseconds cap = 60 * millisecond;
      test::BruteForce all;
      all.complete = true;
      for (const Watch& watch : watches_of(problem, requirement)) {
        const Machine machine(problem, watch);
        all.add(test::brute_force(machine, millisecond, cap, 15'000));
      }
      INFO(requirement.name << ": " << name(verdict.state) << ", " << verdict.explanation.text());
      const Nanoseconds found = requirement.at_least ? all.least : all.greatest;
      if (verdict.bound && found >= 0) {
        CHECK((requirement.at_least ? found >= verdict.bound->count() : found <= verdict.bound->count()));
      }
      if (all.failed || all.grown) CHECK(verdict.state != Verdict::State::holds);
      if (verdict.state == Verdict::State::never) CHECK(found < 0);
      if (!all.complete || all.greatest >= cap || all.grown) continue;
      const bool broken = requirement.at_least ? found < requirement.limit : found > requirement.limit;
      if (verdict.state == Verdict::State::fails && !verdict.bound) CHECK((all.failed || broken));
      if (!verdict.exact) continue;
      ++compared;
      if (verdict.bound) {
        CHECK_FALSE(all.failed);
        CHECK(std::max<Nanoseconds>(found, 0) == verdict.bound->count());
      } else {
        CHECK(all.failed);
      }
    }
  }
  std::cout << compared << " bounds compared with all runs\n";
  CHECK(compared > 0);
}

TEST_CASE("no simulated run exceeds a proved load in the long run") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 10);
  std::size_t proved = 0;
  std::size_t exact = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    std::string text;
    const auto skill = accepted(seed, 9, text);
    if (!skill) continue;
    INFO("seed " << seed << "\n" << text);
    const Problem& problem = *skill->problem;
    const Watch nothing;
    const Machine machine(problem, nothing);
    ZoneGraph graph(machine, 0, true);
    const Limits limits{30'000, {}};
    if (!graph.explore(limits)) continue;
    std::vector<ProcessorId> processors;
    for (const ProcessorId p : problem.processors.ids()) processors.push_back(p);
    const std::vector<LoadBound> bounds = load_bounds(machine, graph, processors, limits);
    for (const LoadBound& bound : bounds) {
      proved += bound.proved ? 1 : 0;
      exact += bound.exact ? 1 : 0;
    }
    for (std::uint64_t run = 0; run < 8; ++run) {
      SimulationOptions options;
      options.times = run < 2   ? SimulationOptions::Times::worst
                      : run < 4 ? SimulationOptions::Times::best
                                : SimulationOptions::Times::extremes;
      options.seed = seed * 100 + run;
      options.until = 3000 * millisecond;
      options.max_events = 20'000;
      const Simulation made = simulate(machine, options);
      if (made.trace.events.empty()) continue;
      const Nanoseconds end = made.trace.events.back().time_ns;
      Table<ProcessorId, Nanoseconds> busy(problem.processors.size());
      for (const trace::Slice& slice : trace::slices(made.trace)) {
        if (slice.state != trace::State::running) continue;
        const ProcessorId processor = problem.threads[ThreadId::of(slice.actor)].processor;
        busy[processor] += slice.to_ns - slice.from_ns;
      }
      for (const ProcessorId p : busy.ids()) {
        // Beginnings and ends count for nothing in the long run; 100 ms are more than any of these skills'
        // rounds.
        const LoadBound& bound = bounds[p.index()];
        INFO("run " << run << " processor " << p.index() << " busy " << busy[p] << " of " << end << ", bound "
                    << bound.most.work << " / " << bound.most.time);
        const double most = static_cast<double>(bound.most.work) / static_cast<double>(bound.most.time);
        CHECK(static_cast<double>(busy[p]) <= most * static_cast<double>(end) + 100e6);
      }
    }
  }
  std::cout << proved << " loads proved, " << exact << " exactly\n";
  CHECK(exact > 0);
}

TEST_CASE("no unending run exceeds a bound by shares") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 10);
  std::size_t proved = 0;
  std::size_t shown = 0;
  std::size_t equal = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    std::string text;
    const auto skill = accepted(seed, 9, text);
    if (!skill) continue;
    INFO("seed " << seed << "\n" << text);
    Problem problem = *skill->problem;
    // Nanoseconds that no two times share.
    for (const StepId s : problem.steps.ids())
      problem.steps[s].cost.worst +=
          seed % 2 == 0 ? static_cast<Nanoseconds>(1 + s.index() * 7'919 % 100'003) : 0;
    const Watch nothing;
    const Machine machine(problem, nothing);
    ZoneGraph graph(machine, 0, true);
    if (!graph.explore({20'000, {}})) continue;
    for (const Recurrence& recurrence : recurrences(graph)) {
      for (const ProcessorId processor : problem.processors.ids()) {
        const auto most = share_bound(work_graph(machine, graph, recurrence, processor), {}, {});
        if (!most) continue;
        ++proved;
        const auto run = search_unending(machine, graph, recurrence, processor,
                                         [&most](const Fraction& load) { return !greater(*most, load); }, {});
        if (!run) continue;
        ++shown;
        INFO("processor " << processor.index() << ": " << run->load.work << " / " << run->load.time
                          << " shown, " << most->work << " / " << most->time << " proved");
        CHECK_FALSE(greater(run->load, *most));
        equal += greater(*most, run->load) ? 0 : 1;
      }
    }
  }
  std::cout << proved << " loads proved by shares, " << shown << " with a run, " << equal << " attained\n";
  CHECK(equal > 0);
}
