// What the analysis shows, and what the simulator makes, of skills of every kind, before the referee.
#include <catch2/catch.hpp>
#include <iostream>
#include <numeric>

#include "analyzer/analysis.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/kept.hpp"
#include "tests/support/kinds.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/setting.hpp"

using namespace pal;
using namespace pal::analyzer;
using test::setting;

namespace {

struct Tally {
  std::size_t skills = 0;
  std::size_t witnesses = 0;
  std::size_t explained = 0;
  std::size_t events = 0;  // of simulated runs
};

Nanoseconds sum(const std::vector<Addend>& addends) {
  return std::accumulate(addends.begin(), addends.end(), Nanoseconds{0},
                         [](Nanoseconds all, const Addend& each) { return all + each.amount; });
}

void explain(const Analysis& analysis, Tally& tally) {
  for (const Verdict& verdict : analysis.verdicts) {
    INFO(verdict.requirement << ": " << verdict.explanation.text());
    tally.witnesses += verdict.witness ? 1 : 0;
    CHECK(test::unexplained(verdict) == "");
    if (verdict.addends.empty()) continue;
    REQUIRE(verdict.bound);
    CHECK(sum(verdict.addends) == verdict.bound->count());
    ++tally.explained;
  }
}

void simulate_some(const Problem& problem, std::uint64_t seed, Tally& tally) {
  const Watch nothing;
  const Machine machine(problem, nothing);
  using Times = SimulationOptions::Times;
  for (const Times times : {Times::random, Times::extremes, Times::worst, Times::best}) {
    SimulationOptions options;
    options.times = times;
    options.seed = seed;
    options.until = 1'000'000'000;
    options.max_events = 400;
    const trace::Trace made = simulate(machine, options).trace;
    INFO("times " << static_cast<int>(times));
    CHECK(run_checker::check_run(problem, nullptr, made).broken == "");
    tally.events += made.events.size();
  }
}

void expect_sound(const std::string& text, std::uint64_t seed, const std::vector<AnalysisChoice>& choices,
                  Tally& tally) {
  const auto skill = test::any_skill(text);
  if (!skill->problem) return;
  ++tally.skills;
  INFO("seed " << seed << "\n" << text);
  simulate_some(*skill->problem, seed, tally);
  Options options;
  options.max_states = setting("PAL_CLASSES", 200);
  for (const AnalysisChoice choice : choices) {
    const Analysis analysis = analyze(*skill->problem, choice, options);
    CHECK(test::unconfirmed(*skill->problem, analysis) == "");
    explain(analysis, tally);
  }
}

void say(const Tally& tally) {
  std::cout << tally.skills << " skills, " << tally.witnesses << " witnesses, " << tally.explained
            << " explained, " << tally.events << " events simulated\n";
  CHECK(tally.witnesses > 0);
  CHECK(tally.events > 0);
}

void expect_confirmed_kinds(AnalysisChoice choice, test::Part part) {
  Tally tally;
  for (const std::uint64_t seed : test::seeds(21, 6, part)) {
    const int mistakes = static_cast<int>(seed / test::kinds().size() % 4);
    expect_sound(test::Mutant(seed, test::skill_of_any_kind(seed), test::has_meaning).text(mistakes), seed,
                 {choice}, tally);
  }
  say(tally);
}

void expect_confirmed_kept_skills(test::Part part) {
  const std::vector<std::string> all = test::kept_skills();
  Tally tally;
  for (const std::uint64_t seed : test::seeds(0, all.size(), part)) {
    const int mistakes = static_cast<int>(seed / all.size() % 5);
    expect_sound(test::Mutant(seed, all[seed % all.size()], test::has_meaning).text(mistakes), seed,
                 {seed % 2 == 0 ? AnalysisChoice::exact : AnalysisChoice::automatic}, tally);
  }
  say(tally);
}

}  // namespace

TEST_CASE(
    "the referee confirms every run shown for skills of every kind that are analysed exactly, and "
    "explanations add up, part 1 of 3") {
  expect_confirmed_kinds(AnalysisChoice::exact, {1, 3});
}

TEST_CASE(
    "the referee confirms every run shown for skills of every kind that are analysed exactly, and "
    "explanations add up, part 2 of 3") {
  expect_confirmed_kinds(AnalysisChoice::exact, {2, 3});
}

TEST_CASE(
    "the referee confirms every run shown for skills of every kind that are analysed exactly, and "
    "explanations add up, part 3 of 3") {
  expect_confirmed_kinds(AnalysisChoice::exact, {3, 3});
}

TEST_CASE(
    "the referee confirms every run shown for skills of every kind that are analysed automatically, and "
    "explanations add up, part 1 of 3") {
  expect_confirmed_kinds(AnalysisChoice::automatic, {1, 3});
}

TEST_CASE(
    "the referee confirms every run shown for skills of every kind that are analysed automatically, and "
    "explanations add up, part 2 of 3") {
  expect_confirmed_kinds(AnalysisChoice::automatic, {2, 3});
}

TEST_CASE(
    "the referee confirms every run shown for skills of every kind that are analysed automatically, and "
    "explanations add up, part 3 of 3") {
  expect_confirmed_kinds(AnalysisChoice::automatic, {3, 3});
}

TEST_CASE("kept skills: the referee confirms every run, and explanations add up, part 1 of 2") {
  expect_confirmed_kept_skills({1, 2});
}

TEST_CASE("kept skills: the referee confirms every run, and explanations add up, part 2 of 2") {
  expect_confirmed_kept_skills({2, 2});
}
