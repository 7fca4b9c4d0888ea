// Classes that replace one another in long rows.
#include <catch2/catch.hpp>
#include <chrono>

#include "analyzer/exact/zeno_run.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/project_file.hpp"

using namespace pal;
using namespace pal::analyzer;

TEST_CASE("classes that grow with every turn of a loop are compared quickly") {
  const auto skill = test::any_skill(test::project_file("tests/differential/told/growing.pal"));
  INFO(test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  Limits limits;
  limits.classes = 200'000;
  const auto begun = std::chrono::steady_clock::now();
  CHECK_FALSE(find_zeno_run(*skill->problem, limits).found);
  // Going from each class that was replaced to the next takes hours.
  CHECK(std::chrono::steady_clock::now() - begun < std::chrono::seconds(60));
}
