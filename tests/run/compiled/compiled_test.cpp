// Random skills, generated and compiled, against the interpreter of plans and against the simulator.
#include <catch2/catch.hpp>
#include <iostream>
#include <sstream>

#include "codegen/plan.hpp"
#include "pal/runtime/still_world.hpp"
#include "tests/run/compiled/compiled_skill.hpp"
#include "tests/run/compiled/follow.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/drawn_program.hpp"
#include "tests/support/planned_skill.hpp"
#include "tests/support/retold_run.hpp"
#include "tests/support/setting.hpp"

using namespace pal;
using runtime::CostPolicy;

namespace {

/// One of the compiled skills, and the plan that its text gives now.
struct Both {
  explicit Both(const test::CompiledSkill& compiled)
      : compiled_skill(compiled), skill(test::any_skill(compiled.text)) {
    REQUIRE(skill->problem);
    Diagnostics diagnostics;
    plan = codegen::make_plan(skill->specification.skills.front(), skill->specification.environments.front(),
                              skill->sources, diagnostics);
    REQUIRE(plan);
  }
  const test::CompiledSkill& compiled_skill;
  std::unique_ptr<test::Skill> skill;
  std::optional<codegen::Plan> plan;
};

/// Without the notes of broken promises: the devices of the test keep none, and an interpreted skill has
/// fewer of them.
runtime::Outcome run(runtime::Skill& skill, const codegen::Plan& plan, test::Payloads payloads,
                     std::uint64_t seed, CostPolicy costs) {
  std::vector<std::unique_ptr<runtime::Device>> devices;
  std::vector<runtime::Device*> attached;
  for (const std::string& name : plan.devices) {
    devices.push_back(test::planned_device(plan, name, test::dealer(seed + devices.size() + 1), payloads));
    attached.push_back(devices.back().get());
  }
  runtime::StillWorld world;
  runtime::Outcome outcome =
      runtime::Dispatcher(attached, world)
          .run(skill, {},
               {.costs = costs,
                .seed = seed,
                .horizon = std::chrono::milliseconds(100),
                .trace = runtime::TraceMode::last,  // of a run that spins at one instant; others are shorter
                .trace_capacity = 4096});
  std::erase_if(outcome.trace.events,
                [](const trace::Event& event) { return event.kind == trace::Kind::broken; });
  return outcome;
}

runtime::Outcome run_compiled(const Both& both, std::uint64_t seed, CostPolicy costs) {
  const auto skill = both.compiled_skill.make(test::dealer(seed));
  return run(*skill, *both.plan, test::Payloads::zeros, seed, costs);
}

runtime::Outcome run_interpreted(const Both& both, std::uint64_t seed, CostPolicy costs) {
  test::PlannedSkill skill(*both.plan, test::dealer(seed));
  return run(skill, *both.plan, test::Payloads::none, seed, costs);
}

std::string told(const trace::Trace& run, std::size_t from, std::size_t count) {
  std::ostringstream out;
  for (std::size_t e = from; e < std::min(from + count, run.events.size()); ++e) {
    const trace::Event& event = run.events[e];
    out << event.time_ns << " " << trace::name(event.kind) << " "
        << (event.actor < 0 ? "" : run.actors[static_cast<std::size_t>(event.actor)].name) << " "
        << (event.statement < 0 ? "" : run.statements[static_cast<std::size_t>(event.statement)].text) << " "
        << event.subject << " " << event.value << "\n";
  }
  return out.str();
}

/// Where the runs differ; empty: nowhere.
std::string difference(const runtime::Outcome& compiled, const runtime::Outcome& interpreted) {
  const auto& a = compiled.trace.events;
  const auto& b = interpreted.trace.events;
  std::size_t same = 0;
  while (same < std::min(a.size(), b.size()) && a[same] == b[same]) ++same;
  if (same < std::max(a.size(), b.size()))
    return "compiled\n" + told(compiled.trace, same, 5) + "interpreted\n" + told(interpreted.trace, same, 5);
  if (compiled.code != interpreted.code || compiled.fault != interpreted.fault)
    return "another end: " + compiled.reason + ", " + interpreted.reason;
  if (compiled.reason != interpreted.reason) return compiled.reason + ", " + interpreted.reason;
  if (compiled.duration != interpreted.duration || compiled.overruns != interpreted.overruns)
    return "another duration, or other overruns";
  return {};
}

/// The run up to the instant before a fault, which is no event of the execution model.
trace::Trace sound_part(runtime::Outcome outcome) {
  if (outcome.fault) {
    const std::int64_t end = outcome.trace.events.empty() ? 0 : outcome.trace.events.back().time_ns;
    std::erase_if(outcome.trace.events, [end](const trace::Event& event) { return event.time_ns >= end; });
  }
  return std::move(outcome.trace);
}

constexpr std::pair<CostPolicy, const char*> modes[] = {
    {CostPolicy::worst, "worst"}, {CostPolicy::best, "best"}, {CostPolicy::random, "seeded"}};

struct Count {
  std::size_t skills = 0;
  std::size_t runs = 0;
  std::size_t events = 0;
  std::size_t completed = 0;
};

std::ostream& operator<<(std::ostream& out, const Count& count) {
  return out << count.skills << " skills, " << count.runs << " runs of " << count.events << " events, "
             << count.completed << " to a completion";
}

}  // namespace

TEST_CASE("compiled skills do what their plans say, event by event") {
  Count count;
  const std::uint64_t runs = test::setting("PAL_RUNS", 1);
  for (const test::CompiledSkill& compiled : test::compiled_skills()) {
    INFO("seed " << compiled.seed << "\n" << compiled.text);
    const Both both(compiled);
    ++count.skills;
    for (const auto& [costs, mode] : modes) {
      for (std::uint64_t seed = compiled.seed * 100; seed < compiled.seed * 100 + runs; ++seed) {
        INFO(mode << " times, seed " << seed);
        const runtime::Outcome made = run_compiled(both, seed, costs);
        ++count.runs;
        count.events += made.trace.events.size();
        count.completed += made.fault ? 0 : 1;
        CHECK(difference(made, run_interpreted(both, seed, costs)) == "");
      }
    }
  }
  std::cout << count << ": the same as interpreted\n";
  CHECK(count.completed > 0);
}

TEST_CASE("the simulator's machine can make each run of a compiled skill, event by event") {
  Count count;
  for (const test::CompiledSkill& compiled : test::compiled_skills()) {
    const Both both(compiled);
    const analyzer::Problem& problem = *both.skill->problem;
    ++count.skills;
    for (const auto& [costs, mode] : modes) {
      const std::uint64_t seed = compiled.seed * 100;
      INFO("seed " << compiled.seed << ", " << mode << " times\n" << compiled.text);
      runtime::Outcome made = run_compiled(both, seed, costs);
      const bool completed = !made.fault;
      const trace::Trace whole = test::retold_run(sound_part(std::move(made)), problem);
      if (whole.events.empty()) continue;  // it ends at once
      ++count.runs;
      count.events += whole.events.size();
      count.completed += completed ? 1 : 0;
      const std::string stuck = test::not_followed(problem, whole, costs);
      INFO(told(whole, 0, 400));
      CHECK(stuck == "");
    }
  }
  std::cout << count << ": followed by the simulator\n";
  CHECK(count.completed > 0);
}
