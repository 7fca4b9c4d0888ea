#include "analyzer/whatif/remedy.hpp"

#include <catch2/catch.hpp>

#include "tests/support/skill.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;
using Is = Verdict::State;

namespace {

Remedies remedies_of(const test::Skill& skill, const RemedyOptions& how = {}) {
  return find_remedies(skill.specification.skills.front(), skill.specification.environments.front(), 0, {},
                       Options(), how);
}

std::vector<std::string> changes_of(const Remedies& remedies, const Remedy& remedy) {
  std::vector<std::string> all;
  for (const CandidateId id : remedy.made) {
    for (const Change& each : remedies.candidates[id.index()].changes) all.push_back(text(each));
  }
  return all;
}

}  // namespace

TEST_CASE("nothing is tried of a skill that meets everything") {
  const Remedies remedies = remedies_of(*test::sound_skill(test::two_chains("7 ms")));
  CHECK(remedies.tried == 0);
  CHECK(remedies.found.empty());
}

TEST_CASE("a priority mends a late answer, and the new verdict is shown") {
  const auto skill = test::sound_skill(test::two_chains("4 ms"));
  const Remedies remedies = remedies_of(*skill);
  REQUIRE(remedies.before.front().state == Is::fails);
  REQUIRE_FALSE(remedies.found.empty());
  CHECK(changes_of(remedies, remedies.found.front()) == std::vector<std::string>{"SM1.priority = 3"});
  for (const Remedy& remedy : remedies.found) {
    CHECK(remedy.made.size() == 1);
    CHECK(remedy.after.front().state == Is::holds);
    CHECK(remedy.after.front().bound <= Duration(4'000'000));
  }
}

TEST_CASE("if no change suffices, the nearest one is shown") {
  const auto skill = test::sound_skill(test::two_chains("1 ms"));  // the answer alone takes 2 ms
  RemedyOptions how;
  how.most_changes = 2;
  const Remedies remedies = remedies_of(*skill, how);
  CHECK(remedies.found.empty());
  CHECK(remedies.complete);
  REQUIRE(remedies.nearest);
  CHECK(remedies.nearest->after.front().bound < remedies.before.front().bound);
}

TEST_CASE("the nearest change breaks nothing that holds") {
  // With a higher priority the answer comes sooner, but then it delays heavy.
  std::string text = test::two_chains("1 ms");
  text.insert(text.find("END SKILL"),
              "  REQUIREMENT steady : RESPONSE FROM tock OF SD1 TO heavy AT MOST 5 ms\n");
  RemedyOptions how;
  how.most_changes = 1;
  const Remedies remedies = remedies_of(*test::sound_skill(text), how);
  CHECK(remedies.found.empty());
  REQUIRE(remedies.nearest);
  REQUIRE(remedies.before.back().state == Is::holds);
  CHECK(remedies.nearest->after.back().state == Is::holds);
  CHECK(remedies.nearest->after.front().bound < remedies.before.front().bound);
}

TEST_CASE("a program that cannot be changed in this way is passed over") {
  const auto skill = test::sound_skill(test::two_chains("4 ms"));
  std::size_t asked = 0;
  const Remedies remedies = find_remedies(
      skill->specification.skills.front(), skill->specification.environments.front(), 3,
      [&](const std::vector<ProgramChangeId>& made) -> const pan::Network* {
        CHECK(made.size() == 1);
        ++asked;
        return nullptr;
      },
      Options());
  CHECK(asked == 3);
  CHECK_FALSE(remedies.found.empty());
  CHECK_FALSE(remedies.candidates[remedies.found.front().made.front().index()].program.valid());
}
