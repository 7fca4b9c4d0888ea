// Programs for which simulated <= exact <= compositional was once violated, or an analysis did not end.
#include <catch2/catch.hpp>
#include <utility>

#include "analyzer/analysis.hpp"
#include "analyzer/compositional/compositional.hpp"
#include "tests/property/sandwich.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/woven_skill.hpp"

using namespace pal;
using namespace pal::analyzer;

TEST_CASE("cases in which the order was once broken") {
  test::Tally tally;
  // A wait at the start that gives up opens a device before the wait that is its taker's home. A request that
  // is withdrawn before its server takes it brings no round about. While a CONCURRENT waits for one of its
  // blocks, statements of another that is over come no more.
  for (const auto& [seed, longest] : {std::pair{123801U, 40}, {30010203U, 40}, {30033352U, 9}}) {
    const auto skill = test::skill_from_text(test::RandomSkill(seed, longest).text());
    REQUIRE(skill->problem);
    test::expect_sandwich(*skill->problem, seed, 300, tally);
  }
}

TEST_CASE("a loop in no time is looked for in a part of the classes") {
  // Some edges of that part lead to classes that others have replaced.
  const auto skill = test::meaningful_skill(test::WovenSkill(5014).text());
  Options options;
  options.max_states = 300;
  options.threads = 1;
  CHECK(analyze(*skill->problem, AnalysisChoice::automatic, options).verdicts.size() ==
        skill->problem->requirements.size());
}

TEST_CASE("an answer that is sent twice is there before the next request") {
  // LS1's second answer is SD1's spare one: it does not take the sensor's 2 ms. So nothing is said of such
  // skills.
  const auto skill = test::sound_skill(test::project_file("tests/property/sandwich/sent_twice.pal"));
  const Analysis above = compositional::analyze(*skill->problem);
  const Analysis exact = analyze_exactly(*skill->problem);
  REQUIRE(exact.verdicts.front().exact);
  CHECK(exact.verdicts.front().bound == Duration(1'000'000));
  CHECK_FALSE(above.verdicts.front().bound);
}
