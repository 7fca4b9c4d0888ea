// The regulator of press and rub on a surface like a spring, without an arm.
#include <catch2/catch.hpp>
#include <cmath>

#include "pal/runtime/skill.hpp"
#include "skills_pal/modules/approach.hpp"
#include "skills_pal/modules/looking.hpp"
#include "skills_pal/modules/overload.hpp"
#include "tests/run/skills/support/spring_surface.hpp"

using namespace pal::skills;
using namespace pal::test;

namespace {

constexpr double target = 5;  // N

double greatest_error(const SpringSurface& surface, double assumed, int cycles_old) {
  return regulated_errors(surface, assumed, cycles_old, [] { return 0.0; }).greatest;
}

}  // namespace

TEST_CASE("the force reaches its target with a stiffness of a third to three times the given one") {
  const double stiffness = GENERATE(3.7, 5.0, 11.0, 20.0, 33.0);
  const double slope = GENERATE(0.0, 0.14, -0.14);  // 5 mm/s
  CAPTURE(stiffness, slope);
  CHECK(greatest_error({stiffness, slope}, 11, 0) < 0.1 * target);
}

TEST_CASE("the regulator oscillates with a force that is one cycle older") {
  const SpringSurface waves{20, 0, 0.05};  // 1 mm up and down in 100 mm, at 28 mm/s
  CHECK(greatest_error(waves, 11, 0) < 0.5);
  CHECK(greatest_error(waves, 11, 1) > 5);  // the tool leaves the surface
}

TEST_CASE("a speed that would overload the sensor is refused, and a lower one is named") {
  CHECK_NOTHROW(refuse_overload(5, 60, 11));
  CHECK_THROWS_AS(refuse_overload(40, 60, 11), pal::runtime::ParameterError);
  CHECK_NOTHROW(refuse_overload(40, 27.1, 11));
  CHECK_THROWS_AS(refuse_overload(40, 27.3, 11), pal::runtime::ParameterError);
}

TEST_CASE("an approach reports its reach three steps later, and comes home exactly") {
  Approach approach;
  approach.start(20, 1);
  double gone = 0;
  int steps = 0;
  for (; !approach.felt_reach(); ++steps) gone += approach.step_forward();
  CHECK(gone == Approx(1));
  CHECK(steps == 2 + 3);
  while (!approach.at_home()) gone += approach.step_back();
  CHECK(gone == Approx(0).margin(1e-12));
}

TEST_CASE("a look counts after twelve cycles of standing, and only once") {
  Looking looking;
  looking.start(1, 0.5);
  Way way;
  way.dz = 2.5;
  way.rx = -1;
  looking.go(way);
  double dz = 0, rx = 0;
  for (int i = 0; i < 3 + 11; ++i) {
    CHECK_FALSE(looking.fresh_look(i));
    const Way step = looking.step();
    CHECK(std::abs(step.dz) <= 1);
    CHECK(std::abs(step.rx) <= 0.5);
    dz += step.dz;
    rx += step.rx;
  }
  CHECK(dz == Approx(2.5));
  CHECK(rx == Approx(-1));
  looking.step();
  CHECK(looking.fresh_look(100));
  CHECK_FALSE(looking.fresh_look(100));
  CHECK(looking.fresh_look(178));
}
