// The limits of the requirements on profiles come from physics. LS2 takes longer than workcell.pal says, on a
// processor of its own. So its result is old while all else is in time.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/run/skills/support/seam.hpp"
#include "tests/run/skills/support/slowed_cell.hpp"

using namespace pal;
using namespace pal::test;

namespace {

constexpr std::size_t few = 5000;  // states: enough to see that a requirement fails

double turned(const workcell::SessionResult& result) {
  double turned = 0;
  for (std::size_t i = 1; i < result.log.size(); ++i)
    turned += result.log[i].set_point_turn.angularDistance(result.log[i - 1].set_point_turn);
  return turned * 180 / 3.14159265358979;
}

double nearest(const workcell::SessionResult& result) {
  double least = 1e9;
  for (const sim::Sample& sample : result.log) least = std::min(least, sample.tool.z() * 1e3);
  return least;
}

}  // namespace

TEST_CASE(
    "standoff: with looks older than fresh-look allows, it comes nearer to the surface than it was told") {
  constexpr double plate = -105;  // mm
  const PhysicalRun wanted{
      .skill = "standoff", .scene = "flat", .parameters = {{"distance", 150}, {"speed", 3}}};
  CHECK(nearest(run(wanted)) > plate + 150 - 0.5);

  // It goes by what was scanned on the way.
  Cell slower(slowed(wanted, {"LS2", "find-nearest", 240, "P3"}), few);
  CHECK(slower.fails("fresh-look"));
  CHECK(nearest(slower.run()) < plate + 150 - 2);
}

TEST_CASE("align: with looks older than fresh-look allows, it turns too far") {
  const double lean = 13;  // 12 degrees about x and 5 about y
  const PhysicalRun wanted{.skill = "align", .scene = "tilted", .parameters = {{"tolerance", 2}}};
  CHECK(turned(run(wanted)) < 1.4 * lean);

  Cell slower(slowed(wanted, {"LS2", "fit-surface", 240, "P3"}), few);
  CHECK(slower.fails("fresh-look"));
  CHECK(turned(slower.run()) > 1.7 * lean);
}

TEST_CASE("follow-edge: with edges older than fresh-edge allows, it leaves the edge at 30 mm/s") {
  // Over the last 3 of 6 cm, mm.
  const auto off_edge = [](const workcell::SessionResult& result) {
    const Seam seam;
    double greatest = 0;
    for (const sim::Sample& sample : result.log)
      if ((sample.tool - result.log.front().tool).x() > 0.03 && sample.time <= result.outcome.duration)
        greatest = std::max(greatest, off(seam, sample, 200).length);
    return greatest;
  };
  const PhysicalRun wanted{
      .skill = "follow-edge",
      .scene = "seam-crease",
      .parameters = {{"track", 0.84}, {"distance", 6}, {"translation", 3}, {"rotation", 1}}};
  CHECK(off_edge(run(wanted)) < 1);

  Cell slower(slowed(wanted, {"LS2", "find-edge", 240, "P3"}), few);
  CHECK(slower.fails("fresh-edge"));
  CHECK(off_edge(slower.run()) > 2);
}
