// The runtime against the analyzer: random programs, run as generated code would run them. Every run keeps
// the rules, and measures no more than was proved.
#include <catch2/catch.hpp>
#include <iostream>
#include <map>
#include <sstream>

#include "analyzer/exact/exact.hpp"
#include "analyzer/run_checker/check_run.hpp"
#include "codegen/plan.hpp"
#include "pal/runtime/still_world.hpp"
#include "pal/trace/measure.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/drawn_program.hpp"
#include "tests/support/planned_skill.hpp"
#include "tests/support/retold_run.hpp"
#include "tests/support/setting.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

/// As still as a StillWorld, which the runtime does not know of it: it is asked and advanced at each step.
class Asked final : public runtime::World {
 public:
  void advance_to(runtime::Time) override {}
};

runtime::Outcome outcome_in(runtime::World& world, const codegen::Plan& plan, std::uint64_t seed,
                            runtime::CostPolicy costs, runtime::Time horizon) {
  test::PlannedSkill skill(plan, test::dealer(seed));
  std::vector<std::unique_ptr<runtime::Device>> devices;
  std::vector<runtime::Device*> attached;
  for (const std::string& name : plan.devices) {
    devices.push_back(test::planned_device(plan, name, test::dealer(seed + devices.size() + 1)));
    attached.push_back(devices.back().get());
  }
  runtime::RunOptions options;
  options.costs = costs;
  options.seed = seed;
  options.horizon = horizon;
  options.trace_capacity = 4096;
  return runtime::Dispatcher(attached, world).run(skill, {}, options);
}

/// The same in a world that stands still and in one that is asked. Every fourth seed is run in both.
runtime::Outcome outcome_of(const codegen::Plan& plan, std::uint64_t seed, runtime::CostPolicy costs,
                            runtime::Time horizon) {
  runtime::StillWorld still;
  runtime::Outcome outcome = outcome_in(still, plan, seed, costs, horizon);
  if (seed % 4 == 0) {
    Asked asked;
    const runtime::Outcome other = outcome_in(asked, plan, seed, costs, horizon);
    CAPTURE(seed);
    CHECK(other.reason == outcome.reason);
    CHECK(other.trace.events == outcome.trace.events);
  }
  return outcome;
}

trace::Trace run(const codegen::Plan& plan, std::uint64_t seed, runtime::CostPolicy costs,
                 runtime::Time horizon) {
  runtime::Outcome outcome = outcome_of(plan, seed, costs, horizon);
  std::erase_if(outcome.trace.events,
                [](const trace::Event& event) { return event.kind == trace::Kind::broken; });
  if (outcome.fault) {
    // What led to the fault is a run all the same, up to the instant before.
    const std::int64_t end = outcome.trace.events.empty() ? 0 : outcome.trace.events.back().time_ns;
    std::erase_if(outcome.trace.events, [end](const trace::Event& event) { return event.time_ns >= end; });
  }
  return std::move(outcome.trace);
}

std::string told(const trace::Trace& run) {
  std::ostringstream out;
  for (const trace::Event& event : run.events) {
    out << event.time_ns << " " << trace::name(event.kind) << " "
        << (event.actor < 0 ? "" : run.actors[static_cast<std::size_t>(event.actor)].name) << " "
        << (event.statement < 0 ? std::to_string(event.statement)
                                : run.statements[static_cast<std::size_t>(event.statement)].text)
        << " " << event.subject << " " << event.value << "\n";
  }
  return out.str();
}

/// What the trace alone shows of the requirement (trace/include/pal/trace/measure.hpp).
std::pair<std::int64_t, bool> measured(const trace::Trace& run, const Problem& problem,
                                       const Requirement& requirement) {
  std::vector<trace::StatementName> at;
  for (const StepId s : problem.steps.ids()) {
    if (!requirement.at[s] || !problem.steps[s].statement.valid()) continue;
    const Statement& of = problem.statements[problem.steps[s].statement];
    at.push_back({of.module, of.text, of.line});
  }
  std::vector<trace::Occurrence> found;
  bool failed = false;
  if (requirement.measure == Requirement::Measure::age) {
    found = trace::ages(run, problem.conditions[requirement.condition], at);
  } else {
    const ChannelId channel = requirement.events.front();
    const auto responses =
        trace::responses(run, sender_name(problem, channel), problem.channels[channel].message, at);
    found = responses.answered;
    failed = responses.missed > 0;
  }
  const trace::Occurrence* longest = trace::longest(found);
  return {longest == nullptr ? -1 : longest->length_ns(), failed};
}

}  // namespace

TEST_CASE("runs of the runtime keep the rules, and exceed no bound") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 25);
  const std::uint64_t runs = setting("PAL_RUNS", 9);
  const int longest = static_cast<int>(setting("PAL_LONGEST", 5));
  std::size_t skills = 0, traces = 0, events = 0, values = 0, attained = 0, within = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = test::drawn_program(seed, longest);
    const auto skill = test::any_skill(text);
    if (!skill->problem) continue;
    Diagnostics diagnostics;
    const auto plan =
        codegen::make_plan(skill->specification.skills.front(), skill->specification.environments.front(),
                           skill->sources, diagnostics);
    INFO("seed " << seed << "\n" << text << test::messages(diagnostics));
    REQUIRE(plan);
    const Problem& problem = *skill->problem;
    Options options;
    options.max_states = setting("PAL_CLASSES", 3'000);
    const Analysis analysis = analyze_exactly(problem, options);
    ++skills;
    within += std::any_of(problem.threads.begin(), problem.threads.end(),
                          [](const Thread& thread) { return thread.name.find('/') != std::string::npos; });
    for (std::uint64_t each = 0; each < runs; ++each) {
      const auto costs = each % 3 == 0   ? runtime::CostPolicy::worst
                         : each % 3 == 1 ? runtime::CostPolicy::best
                                         : runtime::CostPolicy::random;
      const auto made =
          test::retold_run(run(*plan, seed * 100 + each, costs, std::chrono::milliseconds(200)), problem);
      if (made.events.empty()) continue;  // it spins at its beginning
      ++traces;
      events += made.events.size();
      std::string wrong;
      for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
        const Requirement& requirement = problem.requirements[r];
        if (requirement.measure == Requirement::Measure::load) continue;
        const Verdict& verdict = analysis.verdicts[r];
        const run_checker::Ruling ruling = run_checker::check_run(problem, &requirement, made);
        if (!ruling.broken.empty() && wrong.empty()) wrong = "broken " + ruling.broken;
        const auto [value, failed] = measured(made, problem, requirement);
        std::int64_t confirmed = -1;
        for (const run_checker::Measured& of : ruling.measured) confirmed = std::max(confirmed, of.value);
        if (wrong.empty() && !failed && confirmed != value)
          wrong = requirement.name + " measures " + std::to_string(value) + ", the referee " +
                  std::to_string(confirmed);
        if (wrong.empty() && ruling.failed != failed) wrong = requirement.name + " failed or not";
        values += value >= 0 ? 1 : 0;
        attained += verdict.bound && value == verdict.bound->count() ? 1 : 0;
        if (wrong.empty() && verdict.bound && (failed || value > verdict.bound->count()))
          wrong = requirement.name + " bound " + std::to_string(verdict.bound->count()) + " measured " +
                  std::to_string(value);
        if (wrong.empty() && verdict.state == Verdict::State::holds && (failed || value > requirement.limit))
          wrong = requirement.name + " holds, and measured " + std::to_string(value);
      }
      if (wrong.empty()) continue;
      std::cout << "seed " << seed << " run " << each << ": " << wrong << std::endl;
      INFO("run " << each << "\n" << told(made));
      CHECK(wrong == "");
      break;
    }
  }
  std::cout << skills << " skills, " << traces << " runs of " << events << " events, " << values
            << " values, " << attained << " at the bound; " << within
            << " skills with blocks in executed blocks\n";
  CHECK(traces > 0);
}

namespace {

/// Some of the requirements of the text get a phase.
std::string with_phases(const std::string& text, std::uint64_t seed) {
  static const char* const phases[] = {" AFTER think IN SM1", " DURING REPEAT OF think IN SM1",
                                       " AFTER TXM( motion to MC1 ) IN SM1",
                                       " DURING REPEAT OF TXM( motion to MC1 ) IN SM1"};
  std::istringstream in(text);
  std::string out, line;
  for (std::uint64_t number = seed; std::getline(in, line); ++number) {
    const bool may = line.find("REQUIREMENT") != std::string::npos &&
                     line.find("LOAD") == std::string::npos && line.find("BUSY") == std::string::npos &&
                     line.find("DURATION") == std::string::npos;
    out += line + (may && number % 2 == 0 ? phases[number / 2 % 4] : "") + "\n";
  }
  return out;
}

/// What the referee measures in the run: the worst of the requirement, and whether the run breaks it.
std::pair<std::optional<std::int64_t>, bool> refereed(const Problem& problem, const Requirement& requirement,
                                                      const trace::Trace& made, std::string& wrong) {
  const run_checker::Ruling ruling =
      run_checker::check_run(problem, &requirement, made, std::nullopt, run_checker::BusyFrom::beginning);
  if (!ruling.broken.empty()) wrong = "broken " + ruling.broken;
  std::optional<std::int64_t> worst;
  for (const run_checker::Measured& of : ruling.measured)
    worst = requirement.at_least ? std::min(worst.value_or(of.value), of.value)
                                 : std::max(worst.value_or(of.value), of.value);
  const bool over = worst && (requirement.at_least ? *worst < requirement.limit : *worst > requirement.limit);
  return {worst, over || ruling.failed};
}

}  // namespace

TEST_CASE("what a run watches of each requirement is what the referee measures in its trace") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 30);
  std::map<Requirement::Measure, int> values, breaches;
  int phases = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string plain =
        test::RandomCell(seed, 5, static_cast<int>(seed % 3), test::RandomCell::Asks::all).text();
    auto skill = test::any_skill(with_phases(plain, seed));
    if (!skill->problem) skill = test::any_skill(plain);
    if (!skill->problem) continue;
    Diagnostics diagnostics;
    const auto plan =
        codegen::make_plan(skill->specification.skills.front(), skill->specification.environments.front(),
                           skill->sources, diagnostics);
    REQUIRE(plan);
    const Problem& problem = *skill->problem;
    const runtime::Outcome outcome =
        outcome_of(*plan, seed, runtime::CostPolicy::random, std::chrono::milliseconds(200));
    constexpr std::size_t usual = 20'000;  // more are of a run that does not get beyond an instant
    if (outcome.trace.events.size() > usual) continue;
    // The referee knows nothing of faults and of what is noted.
    trace::Trace events = outcome.trace;
    std::erase_if(events.events, [&outcome](const trace::Event& event) {
      return event.kind == trace::Kind::broken || event.kind == trace::Kind::fault ||
             (outcome.fault && event.kind == trace::Kind::complete);
    });
    const trace::Trace made = test::retold_run(events, problem);
    INFO("seed " << seed << "\n" << skill->sources.text(FileId(std::size_t{0})));
    for (const Requirement& requirement : problem.requirements) {
      if (requirement.measure == Requirement::Measure::load) continue;
      const auto live = std::find_if(
          outcome.requirements.begin(), outcome.requirements.end(),
          [&requirement](const runtime::MeasuredRequirement& each) { return each.name == requirement.name; });
      REQUIRE(live != outcome.requirements.end());
      std::string wrong;
      const auto [worst, breaks] = refereed(problem, requirement, made, wrong);
      if (!wrong.empty()) continue;  // a run that is cut off within an instant
      const std::string start = "requirement " + requirement.name + ",";
      const bool noted = std::any_of(
          outcome.broken_promises.begin(), outcome.broken_promises.end(),
          [&start](const runtime::BrokenPromise& each) { return each.promise.starts_with(start); });
      INFO(requirement.name << " " << requirement.phase.text);
      // After a failure it goes on with what is left; what goes on for too long is noted before it is
      // measured.
      const bool failed = noted && breaks && (requirement.measure == Requirement::Measure::response);
      const std::int64_t watched = live->worst ? live->worst->count() : -1;
      // A busy period that the fault ends counts; the referee does not know that the run is over.
      const bool cut = outcome.fault && requirement.measure == Requirement::Measure::busy;
      if (cut) {
        CHECK(watched >= worst.value_or(-1));
      } else if (!failed) {
        CHECK(watched == worst.value_or(-1));
      }
      const bool grows = requirement.measure == Requirement::Measure::response ||
                         requirement.measure == Requirement::Measure::busy;
      if (grows) {
        CHECK((noted || !breaks));
      } else {
        CHECK(noted == breaks);
      }
      values[requirement.measure] += worst ? 1 : 0;
      breaches[requirement.measure] += noted ? 1 : 0;
      phases += worst && requirement.phase.limits() ? 1 : 0;
    }
  }
  for (const auto& [measure, count] : values)
    std::cout << "measure " << static_cast<int>(measure) << ": " << count << " runs, " << breaches[measure]
              << " broken\n";
  std::cout << phases << " in a phase\n";
  CHECK(values.size() >= 7);
  CHECK(phases > 0);
}

TEST_CASE("a CONCURRENT in an endless loop: the flow says which blocks can end") {
  const auto skill = test::any_skill(R"(MESSAGE tick : SIGNAL
DEVICE robot
SKILL s
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
END SKILL
Machine Controller: MC1
  ACTIVITY hold
BEGIN
  REPEAT
    CONCURRENT
    BEGIN
      WTM( tick from robot )
    END
    BEGIN
      REPEAT
        hold
      UNTIL( forever )
    END
    END CONCURRENT
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY think
BEGIN
  WTM( Coordinator )
  think
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P
  PLACE SM1 ON P PRIORITY 1
  PLACE MC1 ON P PRIORITY 1
  TIME hold : 1 ms
  TIME think : 1 ms
  DEVICE robot EVENT tick EVERY 9 ms
END ENVIRONMENT
)");
  Diagnostics diagnostics;
  const auto plan =
      codegen::make_plan(skill->specification.skills.front(), skill->specification.environments.front(),
                         skill->sources, diagnostics);
  REQUIRE(plan);
  for (const codegen::PlannedThread& thread : plan->threads) {
    INFO(thread.pal_name);
    CHECK(thread.can_end ==
          (thread.pal_name != "MC1" && thread.pal_name != "MC1.2" && thread.pal_name != "SM1"));
  }
}

TEST_CASE("a block within a block begins with what that block had read") {
  using trace::Kind;
  trace::Trace run;
  run.actors = {{"SM1", false, "P", 1}, {"inner", false, "P", 1, 0}, {"innermost", false, "P", 1, 1}};
  run.statements = {{"SM1", "CONCURRENT", "", 1}, {"SM1", "RPC( c )", "", 2}, {"SM1", "think", "", 3}};
  run.conditions = {"c"};
  run.events = {{0, Kind::block, 0, 0, -1, 0}, {0, Kind::start, 1, 1, -1, 0}, {5, Kind::read, 1, 1, 0, 0},
                {5, Kind::done, 1, 1, -1, 0},  {5, Kind::block, 1, 0, -1, 0}, {5, Kind::start, 2, 2, -1, 0},
                {9, Kind::done, 2, 2, -1, 0}};
  const auto found = trace::ages(run, "c", {{"SM1", "think", 3}});
  REQUIRE(found.size() == 1);
  CHECK(found.front().length_ns() == 9);
}
