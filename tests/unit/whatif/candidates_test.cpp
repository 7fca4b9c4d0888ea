#include "analyzer/whatif/candidates.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/whatif/figures.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;

namespace {

bool proposes(const std::vector<Changes>& all, const std::vector<std::string>& one) {
  return std::any_of(all.begin(), all.end(), [&](const Changes& changes) {
    return std::equal(
        changes.begin(), changes.end(), one.begin(), one.end(),
        [](const Change& change, const std::string& as_text) { return text(change) == as_text; });
  });
}

}  // namespace

TEST_CASE("threads of one processor are reordered, moved to one more, and events slowed down") {
  const auto skill = test::sound_skill(test::two_chains("6 ms"));
  const auto all = candidates_for(*skill->problem, skill->specification.environments.front());
  CHECK(proposes(all, {"SM1.priority = 3"}));
  CHECK(proposes(all, {"LS1.priority = 0"}));
  CHECK_FALSE(proposes(all, {"LS1.priority = 3"}));  // it goes first as things are
  CHECK(proposes(all, {"PROCESSOR P1", "SM1.processor = P1"}));
  CHECK(proposes(all, {"MC1.period = 15 ms"}));
  CHECK(proposes(all, {"SD1.period = 40 ms"}));
}

TEST_CASE("a free processor is used before one is added, and a lone thread does not move") {
  const auto skill = test::sound_skill(test::two_chains("6 ms"));
  pan::Environment wide = skill->specification.environments.front();
  REQUIRE(change(wide, "PROCESSOR P7").empty());
  REQUIRE(change(wide, "SM1.processor = P7").empty());
  REQUIRE(change(wide, "PROCESSOR P8").empty());
  Diagnostics diagnostics;
  const auto problem = make_problem(skill->specification.skills.front(), wide, diagnostics);
  REQUIRE(problem);
  const auto all = candidates_for(*problem, wide);
  CHECK(proposes(all, {"SM1.processor = P0"}));
  CHECK_FALSE(proposes(all, {"SM1.processor = P8"}));
}

TEST_CASE("every change that is proposed can be made") {
  const auto skill = test::sound_skill(test::two_chains("6 ms"));
  for (const Changes& changes : candidates_for(*skill->problem, skill->specification.environments.front())) {
    pan::Environment environment = skill->specification.environments.front();
    for (const Change& each : changes) {
      INFO(text(each));
      CHECK(change(environment, text(each)).empty());
    }
    Diagnostics diagnostics;
    CHECK(make_problem(skill->specification.skills.front(), environment, diagnostics));
  }
}

TEST_CASE("a processor is added once, and a block that has no place gets one") {
  const auto skill = test::sound_skill(test::two_chains("6 ms"));
  pan::Environment environment = skill->specification.environments.front();
  CHECK(change(environment, " PROCESSOR P1 ").empty());
  CHECK(environment.processors.size() == 2);
  CHECK(change(environment, "PROCESSOR P1") == "environment cell has a processor P1 already");
  CHECK(change(environment, "SM1.2.processor = P1").empty());
  CHECK(environment.placements.back().thread == "SM1.2");
  CHECK(environment.placements.back().priority == 1);
  CHECK_FALSE(change(environment, "XX.2.processor = P1").empty());
}

TEST_CASE("a change of what there is not is answered with what there is") {
  const auto skill = test::sound_skill(test::two_chains("6 ms"));
  pan::Environment environment = skill->specification.environments.front();
  const auto answer = change(environment, "SENDD = 4 ms");
  INFO(answer);
  CHECK(answer.find("gives no figure for 'SENDD'; there is '") != std::string::npos);
  CHECK(answer.find("'MC1.period'") != std::string::npos);
  CHECK(answer.ends_with("did you mean 'SEND'?"));
  CHECK(change(environment, "MC7.period = 4 ms").find("; there is '") != std::string::npos);
  CHECK(change(environment, "XX.priority = 4").find("'SM1'") != std::string::npos);
}
