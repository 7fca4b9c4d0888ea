// The limits of the requirements come from physics. Take a workcell that is too slow for a requirement. The
// proof says so, a run is as late as the proof says, and the skill does what the requirement should prevent.
// In workcell.pal it does not.
#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/contact_stiffness.hpp"
#include "tests/run/skills/support/slowed_cell.hpp"

using namespace pal;
using namespace pal::test;

TEST_CASE("touch: with forces older than fresh-force allows, it presses too hard") {
  // 0.067 s from the force to the last motion's end, at 20 mm/s, and 0.3 N.
  const double most = 0.067 * 20 * sim::contact_stiffness(scene("touch"), 5, 20) + 0.3;
  const PhysicalRun wanted{.skill = "touch", .scene = "touch", .parameters = {{"approach-speed", 20}}};
  const auto greatest = [](Cell& cell) {
    double overshoot = 0;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6})
      overshoot = std::max(overshoot, cell.run(seed).peak_force - 5);
    return overshoot;
  };
  Cell as_it_is(wanted);
  CHECK_FALSE(as_it_is.fails("fresh-force"));
  CHECK(greatest(as_it_is) < most);
  CHECK(as_it_is.observed("fresh-force") <= 10);

  Cell slower(slowed(wanted, {"LS1", "extract-z", 25}));
  CHECK(slower.fails("fresh-force"));
  CHECK(greatest(slower) > most);
  CHECK(slower.observed("fresh-force") > 10);
  CHECK(slower.within_proof());
}

TEST_CASE("press: with forces older than fresh-force allows, it lands too hard") {
  // 0.067 s at 20 mm/s and 11 N/mm beyond the force at which it has met something; press asks for 5 N.
  constexpr double most = 1 + 0.03 * 20 + 0.067 * 20 * 11;
  const PhysicalRun wanted{
      .skill = "press", .scene = "touch", .parameters = {{"approach-speed", 20}, {"time", 0.5}}};
  const auto as_it_is = run(wanted);
  CHECK(as_it_is.outcome.code == 0);
  CHECK(as_it_is.peak_force < most);

  Cell slower(slowed(wanted, {"LS1", "extract-z", 25}), 20'000);
  CHECK(slower.fails("fresh-force"));
  CHECK(slower.run().peak_force > most);
}

TEST_CASE("rub: with forces older than fresh-force allows, the force leaves its band on waves") {
  const PhysicalRun wanted{
      .skill = "rub", .scene = "waves-100", .parameters = {{"speed", 0.784}, {"distance", 6}}, .raise = -14};
  struct Range {
    double least = 1e9, greatest = -1e9;
  };
  const auto while_sliding = [](const workcell::SessionResult& result) {
    Range range;
    const auto forces = pressing(result);
    for (std::size_t i = 0; i < forces.size() && result.log[i].time <= result.outcome.duration; ++i) {
      if ((result.log[i].tool - result.log.front().tool).x() < 0.01) continue;
      range.least = std::min(range.least, forces[i]);
      range.greatest = std::max(range.greatest, forces[i]);
    }
    return range;
  };
  const Range as_it_is = while_sliding(run(wanted));
  CHECK(as_it_is.least > 1.5);
  CHECK(as_it_is.greatest < 8.5);

  Cell slower(slowed(wanted, {"LS1", "extract-z", 25}));
  CHECK(slower.fails("fresh-force"));
  const Range late = while_sliding(slower.run());
  CHECK(late.least < 1.5);
  CHECK(late.greatest > 8.5);
  CHECK(slower.observed("fresh-force") > 10);
  CHECK(slower.within_proof());
}
