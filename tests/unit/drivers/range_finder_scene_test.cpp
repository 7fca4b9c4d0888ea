// The range finder on the arm, above the step pyramid of Figure 5.19.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "runtime/drivers/range_finder/driver.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/cell/device_views.hpp"
#include "tests/unit/drivers/physics.hpp"
#include "tests/unit/drivers/session.hpp"

namespace pal::sim {
namespace {

using namespace std::chrono_literals;

struct Cell {
  explicit Cell(const std::string& scene, double error_scale = 0)
      : workcell(find_scene(scene, {PAL_SCENE_DIR})),
        finder(timeline, wire.b(), range_view(workcell), {.phase = 0ms, .error_scale = error_scale}) {
    driver.prepare();
    while (!driver.ready()) run(1ms);
    REQUIRE(driver.trouble().empty());
    driver.attach(session);
    driver.open();
  }
  void run(runtime::Time time) { test::run(timeline, workcell, time); }
  std::vector<double> read() {
    session.deliveries.clear();
    driver.receive(0, {});
    run(160ms);
    REQUIRE(session.deliveries.size() == 1);
    return session.deliveries[0].fields;
  }

  runtime::drivers::Timeline timeline;
  runtime::drivers::Wire wire{timeline, runtime::drivers::range_finder::line};
  Workcell workcell;
  RangeFinderEmulator finder;
  runtime::drivers::RangeFinderDriver driver{timeline, wire.a()};
  runtime::drivers::test::Session session{timeline, driver};
};

TEST_CASE("range finder on the arm: it sees the steps of a pyramid, and not the arm", "[range-finder]") {
  Cell cell("pyramid");
  const std::vector<double> fields = cell.read();
  // The table, and four steps of 15 mm on it, whose edges are 60, 45, 30 and 15 mm from the middle.
  const double table = fields[255];
  std::array<int, 5> seen{};
  for (std::size_t i = 0; i < 255; ++i) {
    if (fields[510 + i] == 0) continue;
    const double x = std::abs(fields[i]);
    const auto level = static_cast<int>(std::lround((table - fields[255 + i]) / 15));
    INFO("point " << i << " at " << fields[i] << ", " << fields[255 + i]);
    REQUIRE(level >= 0);
    REQUIRE(level <= 4);
    CHECK(fields[255 + i] == Approx(table - 15 * level).margin(0.11));
    CHECK(x < 75 - 15 * level + (level == 0 ? 1000 : 0.2));
    CHECK(x > 60 - 15 * level - 0.2);
    ++seen[static_cast<std::size_t>(level)];
  }
  for (const int points : seen) CHECK(points > 15);
}

}  // namespace
}  // namespace pal::sim
