// Follow Edge by the thesis's law: what it makes of profiles.
#include "skills_pal/follow_edge/literal_law.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pal::skills;

namespace {

LiteralLaw started() {
  LiteralLaw law;
  law.start({0.5, 0.4}, 10, 200);
  return law;
}

}  // namespace

TEST_CASE("the thesis's law aligns first: y, z and the turn about x") {
  LiteralLaw law = started();
  law.see(3, 198, 10, 0);
  CHECK_FALSE(law.aligned());
  EdgeCorrection made = law.take();
  CHECK(made.y == 0.5);
  CHECK(made.z == -0.5);
  CHECK(made.rx == 0.4);
  CHECK(made.ry == 0);
  CHECK(made.rz == 0);
  made = law.take();  // once a profile
  CHECK(made.y == 0);
  law.see(3, 198, 10, 0);  // scanned while the correction was made
  CHECK(law.take().y == 0);
  law.see(2.5, 198.5, 9.6, 0);
  CHECK(law.take().y == 0.5);
  law.see(0, 200, 0, 0);
  law.see(0.3, 200.1, 0.2, 0);
  CHECK(law.aligned());
  CHECK(law.take().y == Approx(0.3));
}

TEST_CASE("the thesis's law turns about y and z by the last 10 mm") {
  LiteralLaw law = started();
  const double degrees = 180 / 3.14159265358979;
  law.see(0, 200, 0, 0);
  law.take();
  law.see(0.02, 200, 0, 1);
  law.take();
  law.see(0.03, 200.04, 0, 2);
  EdgeCorrection made = law.take();
  CHECK(made.rz == Approx(std::atan(0.05 / 10) * degrees));
  CHECK(made.ry == Approx(-std::atan(0.04 / 10) * degrees));
  law.see(0, 200, 0, 11.5);  // that of 1 mm is forgotten
  made = law.take();
  CHECK(made.rz == Approx(std::atan(0.03 / 10) * degrees));
  law.see(4, 200, 0, 12);  // the history has what was made, not what was missing
  made = law.take();
  CHECK(made.y == 0.5);
  CHECK(made.rz == 0.4);  // limited: atan(0.5 / 10) is 2.9 degrees
}
