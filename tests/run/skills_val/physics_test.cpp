// Pick and place: the numbers of their requirements are those of physics.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/slower.hpp"
#include "tests/run/skills/support/workshop.hpp"
#include "tests/support/built_skills.hpp"

using namespace pal;
using namespace pal::test;
using namespace std::chrono_literals;

namespace {

double in_ms(Duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

/// Runs the skill in a workcell that is slower than workcell.pal.
runtime::Outcome run_slower(Workshop& shop, const std::string& skill, const Slower& slower,
                            ProvedBounds& bounds) {
  const auto slow = slow_down(test::make_skill(skill), slower);
  runtime::Outcome outcome = shop.cell().run(*slow);
  bounds.observe(outcome.trace);
  return outcome;
}

/// The longest time for which the arm was told to stand between two steps down, ms.
double longest_rest(std::span<const sim::Sample> log) {
  double longest = 0;
  std::size_t still = 0;  // since this sample
  bool after_down = false;
  for (std::size_t i = 1; i < log.size(); ++i) {
    const double down = log[i - 1].set_point.z() - log[i].set_point.z();
    if (std::abs(down) < 1e-9) continue;
    if (after_down && down > 0 && i > still + 1)
      longest = std::max(longest, in_ms(log[i].time - log[still].time));
    after_down = down > 0;
    still = i;
  }
  return longest;
}

}  // namespace

TEST_CASE(
    "pick-at-location: what the fingers let go is still between them for as long as fresh-grip allows") {
  Workshop shop(scene("parts"));
  REQUIRE(shop.run("pick-at-location", {{.name = "approach", .value = 100}}).code == 0);

  // A held part has its middle between pads of 20 mm. Let go, it is 35 mm lower when nothing of it is between
  // them.
  const double held = shop.middle("part").z();
  shop.cell().workcell().gripper_open();
  double gone_after = 0;  // ms
  for (int ms = 1; ms <= 200 && gone_after == 0; ++ms) {
    shop.cell().rest(1ms);
    const double fallen = held - shop.middle("part").z();
    if (fallen > 35) gone_after = ms;
  }
  CHECK(gone_after > 80);  // fresh-grip

  // LS3 is very slow. A part may slip out as soon as it was felt. It is then gone when the lift is decided
  // on, and the skill does not see it.
  const Slower slower{"LS3", "feel", 120};
  Workshop late(scene("parts"));
  ProvedBounds late_bounds("pick-at-location", slower);
  CHECK(late_bounds.fails("fresh-grip"));
  CHECK(run_slower(late, "pick-at-location", slower, late_bounds).code == 0);
  CHECK(slower.milliseconds > gone_after);
  CHECK(late_bounds.greatest_part() <= 1);
}

TEST_CASE(
    "place-at-location: slower than prompt allows, the arm stands that much longer between two steps down") {
  Workshop shop(scene("parts"));
  REQUIRE(shop.run("pick-at-location").code == 0);
  REQUIRE(shop.run("place-at-location").code == 0);
  const double pause = longest_rest(shop.log());  // most of it is the line to VAL
  CHECK(pause > 20);

  const Slower slower{"LS1", "extract-z", 60};
  Workshop late(scene("parts"));
  REQUIRE(late.run("pick-at-location").code == 0);
  ProvedBounds bounds("place-at-location", slower);
  CHECK(bounds.fails("prompt"));
  const std::size_t begun = late.cell().workcell().log().size();
  CHECK(run_slower(late, "place-at-location", slower, bounds).code == 0);
  const double longer = longest_rest(std::span(late.cell().workcell().log()).subspan(begun)) - pause;
  CHECK(longer > 15);
  CHECK(longer < 75);
  CHECK(bounds.greatest_part() <= 1);
}
