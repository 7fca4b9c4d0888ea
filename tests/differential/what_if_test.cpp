// What is said of other figures and other places, against runs that are made without the analyzer.
#include <catch2/catch.hpp>

#include <algorithm>
#include <iostream>

#include "analyzer/analysis.hpp"
#include "analyzer/whatif/placement.hpp"
#include "analyzer/whatif/slack.hpp"
#include "tests/differential/by_hand.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/chain_system.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/runs/all_runs.hpp"
#include "tests/support/setting.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;
using test::setting;

namespace {

constexpr Duration nanosecond{1};
constexpr int cap = 60;

/// What all runs make of a requirement.
enum class StillKept { yes, no, not_known };

std::string in_nanoseconds(std::string text) {
  for (std::size_t at = 0; (at = text.find(" ms", at)) != std::string::npos;) text.replace(at, 3, " ns");
  return text;
}

Options few_states() {
  Options options;
  options.max_states = setting("PAL_CLASSES", 3'000);
  return options;
}

/// A skill with those of its requirements that hold, each of a time with a little more than it takes.
class Tight {
 public:
  explicit Tight(std::uint64_t seed) {
    const int deep = static_cast<int>(seed % 2);
    text = in_nanoseconds(test::RandomCell(seed, 3, deep, test::RandomCell::Asks::all).text());
    skill_ = test::any_skill(text);
    if (!skill_->problem) return;
    network = skill_->specification.skills.front();
    environment = skill_->specification.environments.front();
    for (pan::DeviceTiming& timing : environment.devices) {
      if (auto* event = std::get_if<pan::EventDevice>(&timing.behaviour)) event->answer_within.reset();
    }
    std::vector<pan::Requirement> kept;
    for (const pan::Requirement& each : network.requirements) tighten(each, seed, kept);
    network.requirements = std::move(kept);
  }

  std::optional<Problem> problem(const pan::Environment& there) const {
    Diagnostics diagnostics;
    return make_problem(network, there, diagnostics);
  }

  std::string text;
  pan::Network network;
  pan::Environment environment;

 private:
  void tighten(pan::Requirement requirement, std::uint64_t seed, std::vector<pan::Requirement>& kept) const {
    pan::Network alone = network;
    alone.requirements = {requirement};
    Diagnostics diagnostics;
    const auto problem = make_problem(alone, environment, diagnostics);
    if (!problem || problem->requirements.size() != 1) return;
    const Verdict verdict = analyze_exactly(*problem, few_states()).verdicts.front();
    if (!verdict.bound || !verdict.exact || verdict.state == Verdict::State::never) return;
    const bool timed = verdict.measure != Requirement::Measure::loss &&
                       verdict.measure != Requirement::Measure::interval &&
                       verdict.measure != Requirement::Measure::load;
    if (timed) requirement.limit = *verdict.bound + Duration(seed % 4);
    if (timed || verdict.state == Verdict::State::holds) kept.push_back(std::move(requirement));
  }

  std::unique_ptr<test::Skill> skill_;
};

StillKept kept(const Tight& skill, const pan::Environment& environment, const Requirement& requirement) {
  for (const test::Wanted& wanted : test::wanted(skill.network, environment)) {
    if (wanted.name != requirement.name) continue;
    test::AllRuns runs(skill.network, environment, wanted, nanosecond, cap);
    const test::Seen seen = runs.enumerate(setting("PAL_STATES", 15'000));
    using Kind = test::Wanted::Kind;
    const bool broken =
        wanted.kind == Kind::load    ? seen.load.work * 1'000'000'000 > requirement.limit * seen.load.time
        : wanted.kind == Kind::least ? seen.least >= 0 && seen.least < requirement.limit
                                     : seen.failed || seen.unanswered || seen.greatest > requirement.limit;
    return broken ? StillKept::no : seen.complete ? StillKept::yes : StillKept::not_known;
  }
  return StillKept::not_known;
}

/// A requirement that some run breaks, if one is seen.
std::string broken(const Tight& skill, const pan::Environment& environment) {
  const auto problem = skill.problem(environment);
  REQUIRE(problem);
  for (const Requirement& each : problem->requirements) {
    if (kept(skill, environment, each) == StillKept::no) return each.name;
  }
  return "";
}

pan::Environment grown(const Tight& skill, const std::string& figure, Duration extra) {
  pan::Environment there = skill.environment;
  Interval& time = *find_figure(there, figure);
  time.worst += extra;
  return there;
}

}  // namespace

TEST_CASE("no run breaks a requirement at the slack, and a run does a nanosecond above") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  std::size_t held = 0;
  std::size_t failed = 0;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 5); ++seed) {
    const Tight skill(seed);
    if (skill.network.requirements.empty()) continue;
    const auto problem = skill.problem(skill.environment);
    REQUIRE(problem);
    for (const Slack& slack : slacks(skill.network, skill.environment, few_states())) {
      // Of more there are too many runs.
      if (slack.figure.empty() || !slack.holds || *slack.holds > Duration(6)) continue;
      INFO("seed " << seed << " " << slack.figure << ": " << slack.holds->count() << "\n" << skill.text);
      // Not even on the way there.
      for (Duration extra(0); extra <= *slack.holds; ++extra) {
        CHECK(broken(skill, grown(skill, slack.figure, extra)) == "");
        ++held;
      }
      if (!slack.fails || *slack.fails > Duration(7)) continue;
      REQUIRE(slack.requirement.valid());
      const Requirement& named = problem->requirements[slack.requirement.index()];
      INFO(named.name << " fails with " << slack.fails->count());
      const pan::Environment there = grown(skill, slack.figure, *slack.fails);
      const StillKept seen = kept(skill, there, named);
      CHECK(seen != StillKept::yes);
      failed += seen == StillKept::no ? 1 : 0;
    }
  }
  std::cout << held << " growths that hold, " << failed << " that fail, compared with all runs\n";
  CHECK(held > 0);
  CHECK(failed > 0);
}

namespace {

void expect_right_placements(test::Part part) {
  const std::uint64_t rounds = setting("PAL_ROUNDS", 100);
  std::size_t meet = 0;
  std::size_t refuted = 0;
  for (const std::uint64_t seed : test::seeds(1, rounds, part)) {
    const Tight skill(seed);
    const auto problem = skill.problem(skill.environment);
    if (skill.network.requirements.empty() || !problem || problem->threads.size() > 4) continue;
    RequirementChecker checker(skill.network, few_states());
    PlacementOptions how;
    how.priorities = seed % 2 == 0;
    how.most = 8;
    const Placements on = placements_on(1 + static_cast<int>(seed % 3), skill.environment, checker, how);
    CHECK(on.tried == on.meet.size() + on.refuted.size() + on.undecided.size());
    INFO("seed " << seed << "\n" << skill.text);
    for (const Placed& each : on.meet) {
      CHECK(broken(skill, placed(skill.environment, each.threads)) == "");
      ++meet;
    }
    for (const Placed& each : on.refuted) {
      const Requirement& named = problem->requirements[each.ruling.requirement.index()];
      INFO(named.name);
      const pan::Environment there = placed(skill.environment, each.threads);
      const StillKept seen = kept(skill, there, named);
      CHECK(seen != StillKept::yes);
      refuted += seen == StillKept::no ? 1 : 0;
    }
  }
  std::cout << meet << " placements that meet everything, " << refuted
            << " that are refuted, compared with all runs\n";
  CHECK(meet > 0);
  if (rounds >= 100 && part.number == 1) CHECK(refuted > 0);  // few skills have one, and the last part none
}

}  // namespace

TEST_CASE(
    "no run breaks a placement that meets everything, and some run breaks each refuted one, part 1 of 3") {
  expect_right_placements({1, 3});
}

TEST_CASE(
    "no run breaks a placement that meets everything, and some run breaks each refuted one, part 2 of 3") {
  expect_right_placements({2, 3});
}

TEST_CASE(
    "no run breaks a placement that meets everything, and some run breaks each refuted one, part 3 of 3") {
  expect_right_placements({3, 3});
}

TEST_CASE("figures that are all 0 grow together by the same amount") {
  // MC1 interrupts SM1, receives, obeys and sends: three times 2 ms.
  const auto skill = test::meaningful_skill(test::program("hand/all_zero"));
  const Slack together =
      slacks(skill->specification.skills.front(), skill->specification.environments.front(), few_states())
          .back();
  CHECK(together.figure.empty());
  CHECK(together.exact());
  CHECK(together.holds == Duration(2'000'000));
  CHECK(together.fails == Duration(2'000'001));
}

TEST_CASE("a skill too large to explore is refuted by a run that the referee confirms") {
  Problem problem = test::problem_of(test::pairs_of_drivers(140));
  for (Requirement& each : problem.requirements) each.limit = 4'000'000;
  const pan::Network network;
  RequirementChecker checker(network, Options());
  // Every second one may be interrupted and takes 6 ms then.
  const Ruling ruling = checker.ask(problem, requirements_of(problem));
  CHECK(ruling.state == Verdict::State::fails);
  CHECK(ruling.requirement.index() % 2 == 0);
  problem.requirements = {problem.requirements[ruling.requirement.index()]};
  const Analysis analysis = analyze(problem, AnalysisChoice::automatic);
  REQUIRE(analysis.verdicts.size() == 1);
  CHECK(analysis.verdicts.front().state == Verdict::State::fails);
  REQUIRE(analysis.verdicts.front().witness);
  CHECK(test::unconfirmed(problem, analysis) == "");
}

TEST_CASE("no run refutes a skill that has more threads than can be followed") {
  Problem problem = test::problem_of(test::pairs_of_drivers(2'002));
  for (Requirement& each : problem.requirements) each.limit = 4'000'000;
  problem.requirements = {problem.requirements.front()};
  const pan::Network network;
  RequirementChecker checker(network, Options());
  CHECK(checker.ask(problem, requirements_of(problem)).state == Verdict::State::undecided);
}
