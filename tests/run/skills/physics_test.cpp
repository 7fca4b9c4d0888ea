// The numbers of requirements are those of physics: in a workcell that is too slow for a requirement the
// proof says so, a run is as late as the proof says, and what the requirement is there for goes wrong. In
// workcell.pal it does not.
#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/press.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

using namespace pal;
using namespace pal::test;

namespace {

// The proof and the runs of a skill in a workcell: workcell.pal, or a slower one.
class Cell {
 public:
  explicit Cell(PhysicalRun wanted) : wanted_(std::move(wanted)), bounds_(wanted_.skill, wanted_.slower) {}

  workcell::SessionResult run(std::uint64_t seed = 1) {
    wanted_.seed = seed;
    auto result = test::run(wanted_);
    bounds_.observe(result.outcome.trace);
    return result;
  }
  bool fails(const std::string& requirement) const { return bounds_.fails(requirement); }
  // Of all runs so far, ms.
  double observed(const std::string& requirement) const {
    return std::chrono::duration<double, std::milli>(bounds_.worst().at(requirement).observed).count();
  }
  bool within_proof() const { return bounds_.greatest_part() <= 1; }

 private:
  PhysicalRun wanted_;
  ProvedBounds bounds_;
};

PhysicalRun slowed(PhysicalRun wanted, const Slower& slower) {
  wanted.slower = slower;
  return wanted;
}

}  // namespace

TEST_CASE("touch: with forces older than fresh-force allows, it presses harder than its overshoot may be") {
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
