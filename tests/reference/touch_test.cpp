// The touch skill in its workcell, in both orders: what the README says of them.
#include <catch2/catch.hpp>

#include "analyzer/exact/exact.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

Analysis analyze_touch(const std::string& file) {
  const std::string folder = PAL_SOURCE_DIR "/skills_pal/";
  const auto skill = test::skill_from_files({folder + "touch/" + file, folder + "workcell.pal"});
  INFO(test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  return analyze_exactly(*skill->problem);
}

}  // namespace

TEST_CASE("touch meets its requirements in the workcell, exactly") {
  const Analysis analysis = analyze_touch("touch.pal");
  for (const Verdict& verdict : analysis.verdicts) {
    INFO(verdict.requirement << ": " << verdict.explanation.text());
    CHECK(verdict.state == Verdict::State::holds);
    CHECK((verdict.exact || verdict.requirement == "headroom"));  // two blocks share P0: a bound
    REQUIRE(verdict.bound);
  }
}

TEST_CASE("touch in the order of figure 3.6 decides on a force that is too old") {
  const Analysis analysis = analyze_touch("touch_read_first.pal");
  for (const Verdict& verdict : analysis.verdicts) {
    INFO(verdict.requirement << ": " << verdict.explanation.text());
    const bool age = verdict.requirement == "fresh-force";
    CHECK((verdict.state == Verdict::State::fails) == age);
    CHECK((verdict.exact || verdict.requirement == "headroom"));  // two blocks share P0: a bound
    if (!age) continue;
    Nanoseconds sum = 0;
    for (const Reason& reason : verdict.reasons) sum += reason.to - reason.from;
    CHECK(sum == verdict.bound->count());
  }
}
