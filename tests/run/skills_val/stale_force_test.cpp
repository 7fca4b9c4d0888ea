// place-at-location by a force that is a step old: what fresh-force is there for.
#include <catch2/catch.hpp>
#include <utility>

#include "skills_pal/modules/z_force.hpp"
#include "skills_pal/place_at_location/by_sensor.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

using namespace pal;
using namespace pal::test;
using Eigen::Vector3d;

namespace {

using namespace pal::skills;
using namespace pal::skills::place_at_location;

// Answers with what was felt when it was asked the last time: before the last step.
class FeltBefore final : public LS1Activities {
 public:
  Zforce extract_z(const Wrench& wrench) override { return std::exchange(last_, sensor_.extract_z(wrench)); }

 private:
  ZForceSensor<LS1Activities> sensor_;
  Zforce last_;
};

struct Taken {
  int code = 0;
  double slid = 0;   // mm, the held part in the fingers
  double moved = 0;  // mm, what stands at the place
};

Taken at_a_taken_place(std::unique_ptr<LS1Activities> force) {
  Workshop shop(scene("pallet"));
  REQUIRE(
      shop.run("pick-at-location", {text("location", "PART1"), {.name = "approach", .value = 100}}).code ==
      0);
  const Vector3d stood = shop.middle("part 2"), held = shop.middle("part 1") - shop.tip();
  const auto skill = place_at_location_by(std::move(force));
  const std::vector<runtime::ParameterValue> parameters{text("location", "PART2"),
                                                        {.name = "approach", .value = 100}};
  Taken taken;
  taken.code = shop.cell().run(*skill, parameters).code;
  shop.cell().rest(std::chrono::milliseconds(300));
  taken.slid = (shop.middle("part 1") - shop.tip() - held).norm();
  taken.moved = (shop.middle("part 2") - stood).norm();
  return taken;
}

}  // namespace

TEST_CASE("place-at-location: with a force from before the last step it grips two parts") {
  const Taken fresh = at_a_taken_place(std::make_unique<ZForceSensor<LS1Activities>>());
  CHECK(fresh.code == 1);
  CHECK(fresh.slid < 15);
  CHECK(fresh.moved < 1);

  const Taken late = at_a_taken_place(std::make_unique<FeltBefore>());
  CHECK(late.slid > 15);
  CHECK(late.moved > 1);
}

TEST_CASE("place-at-location: fresh-force fails in the PAL that feels before the step") {
  CHECK(ProvedBounds("place-at-location").all_hold());
  const Rewritten order{
      "        list-step\n        Execute SM2\n        CASE\n          ( pc-ok ):\n"
      "            SPC( pc-down )\n"
      "            TXM( request grip from LS3 )  # both sensors at the same time\n"
      "            TXM( request Zforce from LS1 )\n            WTM( Zforce from LS1 )\n",
      "        TXM( request Zforce from LS1 )\n        WTM( Zforce from LS1 )\n"
      "        list-step\n        Execute SM2\n        CASE\n          ( pc-ok ):\n"
      "            SPC( pc-down )\n            TXM( request grip from LS3 )\n"};
  CHECK(ProvedBounds("place-at-location", order).fails("fresh-force"));
}
