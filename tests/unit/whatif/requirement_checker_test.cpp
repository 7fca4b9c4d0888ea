#include "analyzer/whatif/requirement_checker.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <variant>

#include "analyzer/whatif/figures.hpp"
#include "pal/support/file_system.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;
using Is = Verdict::State;

TEST_CASE("without exploration requirements are decided by bounds and single runs") {
  const auto holds = test::sound_skill(test::two_chains("7 ms"));
  RequirementChecker one(holds->specification.skills.front(), Options());
  CHECK(one.ask(*holds->problem, requirements_of(*holds->problem), {0, {}}).state == Is::holds);

  const auto fails = test::sound_skill(test::two_chains("1 ms"));
  RequirementChecker other(fails->specification.skills.front(), Options());
  const Ruling ruling = other.ask(*fails->problem, requirements_of(*fails->problem), {0, {}});
  CHECK(ruling.state == Is::fails);
  CHECK(ruling.requirement == RequirementId(0));
}

TEST_CASE("timing.md has the methods of a what-if question as the code has them") {
  std::string table = "| round | method | may find | from |\n| --- | --- | --- | --- |\n";
  int number = 0;
  for (const AskingRound& round : asking_rounds()) {
    ++number;
    std::string from = std::to_string(round.from);
    if (from.size() > 3) from.insert(from.size() - 3, ",");
    for (const AskingMethod& each : round.methods) {
      const std::string finds = each.proves && each.refutes ? "holds, fails"
                                : each.proves               ? "holds"
                                                            : "fails";
      table +=
          "| " + std::to_string(number) + " | " + each.name + " | " + finds + " | " + from + " classes |\n";
    }
  }
  const auto page = DiskFileSystem().read(PAL_SOURCE_DIR "/docs/internals/timing.md");
  INFO("docs/internals/timing.md lacks this table:\n" << table);
  CHECK(std::get<std::string>(page).find("\n\n" + table + "\n") != std::string::npos);
}

TEST_CASE("a run that refuted something refutes it again with other figures") {
  const auto skill = test::sound_skill(test::two_chains("6 ms"));
  RequirementChecker checker(skill->specification.skills.front(), Options());
  const RequirementIds all = requirements_of(*skill->problem);
  CHECK_FALSE(checker.refuted(*skill->problem, all, {}).valid());
  REQUIRE(checker.ask(*skill->problem, all).state == Is::fails);
  pan::Environment longer = skill->specification.environments.front();
  REQUIRE(change(longer, "heavy = 5..6 ms").empty());
  CHECK(checker.refuted(*checker.problem(longer), all, {}) == RequirementId(0));
  pan::Environment shorter = skill->specification.environments.front();
  REQUIRE(change(shorter, "heavy = 1 ms").empty());
  CHECK_FALSE(checker.refuted(*checker.problem(shorter), all, {}).valid());
}

TEST_CASE("requirements stay undecided when the time is over") {
  const auto skill = test::sound_skill(test::two_chains("6 ms"));
  RequirementChecker checker(skill->specification.skills.front(), Options());
  const Ruling ruling =
      checker.ask(*skill->problem, requirements_of(*skill->problem), {1'000'000, [] { return true; }});
  CHECK(ruling.state == Is::undecided);
}
