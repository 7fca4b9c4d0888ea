#include "analyzer/whatif/slack.hpp"

#include <catch2/catch.hpp>

#include "tests/support/skill.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;

namespace {

std::vector<Slack> slacks_of(const test::Skill& skill, const Options& options,
                             const SlackObserver& observer = {}) {
  return slacks(skill.specification.skills.front(), skill.specification.environments.front(), options,
                observer);
}

const Slack& of(const std::vector<Slack>& all, const std::string& figure) {
  for (const Slack& slack : all) {
    if (slack.figure == figure) return slack;
  }
  throw std::runtime_error("no figure " + figure);
}

}  // namespace

TEST_CASE("each slack is told once, when it is settled") {
  const auto skill = test::sound_skill(test::two_chains("9 ms"));
  std::vector<Slack> told;
  std::size_t most = 0;
  const auto all = slacks_of(*skill, Options(),
                             {[&](const Slack& slack) { told.push_back(slack); },
                              [&](std::size_t settled, std::size_t of) {
                                CHECK(settled <= of);
                                most = std::max(most, settled);
                              }});
  REQUIRE(told.size() == all.size());
  CHECK(most == all.size());
  for (const Slack& slack : told) {
    CHECK_FALSE(slack.ended);
    CHECK(slack.holds == of(all, slack.figure).holds);
    CHECK(slack.fails == of(all, slack.figure).fails);
  }
  // 2 ms and 5 ms of 9 ms.
  CHECK(of(all, "heavy OF LS1").exact());
  CHECK(of(all, "READ").unlimited);
}

TEST_CASE("with a clock the answers are the same, round by round") {
  const auto skill = test::sound_skill(test::two_chains("9 ms"));
  Options timed;
  double now = 0;
  timed.clock = [&now] { return now += 0.001; };  // each look at the clock takes a millisecond
  const auto with = slacks_of(*skill, timed);
  const auto without = slacks_of(*skill, Options());
  REQUIRE(with.size() == without.size());
  for (std::size_t n = 0; n < with.size(); ++n) {
    INFO(with[n].figure);
    CHECK(with[n].holds == without[n].holds);
    CHECK(with[n].fails == without[n].fails);
  }
}

TEST_CASE("with a clock several threads look at figures at the same time") {
  const auto skill = test::sound_skill(test::two_chains("9 ms"));
  Options alone;
  alone.clock = [] { return 0.0; };
  alone.threads = 1;
  Options together = alone;
  together.threads = 3;
  const auto one = slacks_of(*skill, alone);
  const auto three = slacks_of(*skill, together);
  REQUIRE(one.size() == three.size());
  for (std::size_t n = 0; n < one.size(); ++n) {
    INFO(one[n].figure);
    CHECK(one[n].holds == three[n].holds);
    CHECK(one[n].fails == three[n].fails);
  }
}

TEST_CASE("a search that ends after its first round has both sides of a slack") {
  const auto skill = test::sound_skill(test::two_chains("9 ms"));
  std::size_t turns = 0;
  Options options;
  options.stop = [&] { return turns > 0 && turns >= 10; };
  const auto all = slacks_of(*skill, options, {{}, [&](std::size_t, std::size_t) { ++turns; }});
  const Slack& heavy = of(all, "heavy OF LS1");
  REQUIRE(heavy.holds);
  REQUIRE(heavy.fails);
  CHECK(*heavy.holds < *heavy.fails);
}
