// The zone graph is the same, whichever threads explore it.
#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "analyzer/zones/workers.hpp"
#include "analyzer/zones/zone_graph.hpp"
#include "tests/support/chain_system.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

TEST_CASE("workers do each part once and pass on exceptions") {
  Workers workers(3);
  for (const std::size_t grain : {std::size_t{1}, std::size_t{7}}) {
    std::vector<std::atomic<int>> done(1000);
    workers.each(done.size(), grain, [&](std::size_t i) { ++done[i]; });
    for (const auto& times : done) CHECK(times == 1);
  }
  CHECK_THROWS_AS(workers.each(100, 1,
                               [](std::size_t i) {
                                 if (i == 42) throw std::runtime_error("part");
                               }),
                  std::runtime_error);
  std::atomic<std::size_t> after = 0;
  workers.each(100, 1, [&](std::size_t) { ++after; });
  CHECK(after == 100);
}

TEST_CASE("the zone graph does not depend on the number of threads") {
  std::size_t largest = 0;
  for (const std::uint64_t seed : {1U, 3U, 8U, 11U, 20U}) {
    INFO("seed " << seed);
    const auto skill = test::skill_from_text(test::RandomSkill(seed, 10).text());
    if (!skill->problem) continue;
    const Watch watch = watch_of(*skill->problem, skill->problem->requirements.front());
    const Machine machine(*skill->problem, watch);
    const auto explored = [&](unsigned threads) {
      Workers workers(threads);
      Limits limits;
      limits.classes = 30'000;
      limits.workers = &workers;
      ZoneGraph graph(machine, 100'000'000, true);
      graph.explore(limits);
      return graph;
    };
    const ZoneGraph one = explored(1);
    largest = std::max(largest, one.classes().size());
    for (const unsigned threads : {2U, 5U}) {
      const ZoneGraph other = explored(threads);
      REQUIRE(other.classes().size() == one.classes().size());
      REQUIRE(other.edges().size() == one.edges().size());
      CHECK(other.peak().value == one.peak().value);
      CHECK(other.peak().parent == one.peak().parent);
      bool same = true;
      for (std::size_t c = 0; c < one.classes().size(); ++c) {
        const ZoneClass& mine = one.classes()[c];
        const ZoneClass& theirs = other.classes()[c];
        same = same && mine.state == theirs.state && mine.zone == theirs.zone &&
               mine.parent == theirs.parent && mine.move == theirs.move &&
               mine.replaced_by == theirs.replaced_by;
      }
      for (std::size_t e = 0; e < one.edges().size(); ++e) {
        same =
            same && one.edges()[e].from == other.edges()[e].from && one.edges()[e].to == other.edges()[e].to;
      }
      CHECK(same);
    }
  }
  CHECK(largest >= 30'000);  // otherwise hardly anything was shared
}

TEST_CASE("an exploration can be stopped while it looks for the orders in which modules begin") {
  // Ten modules that begin with work on one processor: more orders than are tried.
  std::string modules;
  std::string places = "  PLACE SM1 ON P PRIORITY 1\n";
  const std::string body = "  ACTIVITY work\nBEGIN\n  REPEAT\n    work\n  UNTIL( forever )\nEND\n";
  std::string controllers;
  for (int m = 1; m < 10; ++m) {
    const std::string name = "MC" + std::to_string(m);
    controllers += (m == 1 ? "" : ", ") + name;
    modules += "Machine Controller: " + name + "\n" + body;
    places += "  PLACE " + name + " ON P PRIORITY 1\n";
  }
  const auto skill = test::skill_from_text(
      "SKILL many\n  MACHINE CONTROLLER " + controllers +
      "\n  SKILL METHOD SM1\n  COMPLETION 0 ERROR\n  REQUIREMENT r : LOAD OF P AT MOST 1 %\nEND SKILL\n" +
      modules +
      "Skill Module: SM1\n  ACTIVITY work\nBEGIN\n  WTM( Coordinator )\n  REPEAT\n    work\n  UNTIL( forever "
      ")\nEND\n" +
      "ENVIRONMENT cell\n  PROCESSOR P\n" + places + "  TIME work : 1 ms\nEND ENVIRONMENT\n");
  REQUIRE(skill->problem);
  const Watch nothing;
  const Machine machine(*skill->problem, nothing);
  int asked = 0;
  Limits limits;
  limits.stop = [&asked] { return ++asked > 2; };
  ZoneGraph graph(machine, 0, true);
  CHECK_FALSE(graph.explore(limits));
  CHECK(asked == 3);
  CHECK(graph.classes().empty());
}

TEST_CASE("an exploration expands few classes with very many timers between two questions whether to stop") {
  const Problem problem = test::problem_of(test::pairs_of_drivers(60));
  const Watch nothing;
  const Machine machine(problem, nothing);
  int asked = 0;
  Limits limits;
  limits.stop = [&asked] { return ++asked > 20; };
  ZoneGraph graph(machine, 0, false);
  CHECK_FALSE(graph.explore(limits));
  // Each has 60 successors.
  CHECK(graph.classes().size() > 1'000);
  CHECK(graph.classes().size() < 20'000);
}

TEST_CASE(
    "an exploration of large classes ends when they take the memory of as many small ones as the limit "
    "allows") {
  const Problem problem = test::problem_of(test::pairs_of_drivers(60));
  const Watch nothing;
  const Machine machine(problem, nothing);
  Limits limits;
  limits.classes = 20'000;
  ZoneGraph graph(machine, 0, false);
  CHECK_FALSE(graph.explore(limits));
  CHECK(graph.classes().size() < limits.classes);
}
