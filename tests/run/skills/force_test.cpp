// Touch, press and rub: each way in which they end, with the arm afterwards where their templates say.
#include <catch2/catch.hpp>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

using namespace pal;
using namespace pal::test;

namespace {

double way_along_z(const workcell::SessionResult& result) {
  return (result.log.front().tool - result.log.back().tool).z() * 1e3;
}

// At the end of the log, which goes on for 0.4 s after the skill, or 0.8 s after a fault of the arm.
bool stands_still(const workcell::SessionResult& result) {
  const auto& last = result.log.back();
  const auto& before = result.log[result.log.size() - 100];
  return (last.tool - before.tool).norm() < 1e-5;
}

}  // namespace

TEST_CASE("touch comes to the plate and presses on it, completion 0, in both orders") {
  const auto result = run({.skill = "touch", .scene = "touch"});
  CHECK(end_of(result.outcome) == "touch 0");
  CHECK(result.resting_force > 5);  // the threshold
  CHECK(stands_still(result));
  const auto read_first = run({.skill = "touch-read-first", .scene = "touch"});
  CHECK(end_of(read_first.outcome) == "touch-read-first 0");
  CHECK(read_first.resting_force > 5);
  CHECK(stands_still(read_first));
}

TEST_CASE("a skill that begins in contact feels how hard the tool presses") {
  Workshop shop(scene("touch"), 2);
  REQUIRE(shop.run("touch").code == 0);
  const double touching = shop.log().back().contact_force;
  REQUIRE(shop.run("touch").code == 0);
  CHECK(shop.log().back().contact_force == Approx(touching).margin(0.5));  // 22 N by a zero under load
  REQUIRE(shop.run("press").code == 0);
  CHECK(shop.log().back().contact_force == Approx(5).margin(0.5));
  REQUIRE(shop.run("rub", {{.name = "distance", .value = 2}}).code == 0);
  for (const sim::Sample& sample : shop.log()) {
    CHECK(sample.contact_force > 1.5);
    CHECK(sample.contact_force < 8.5);
  }
}

TEST_CASE("touch meets nothing and goes back, completion 1, in both orders") {
  const std::vector<runtime::ParameterValue> parameters{{"reach", 10}, {"approach-speed", 40}};
  const auto result = run({.skill = "touch", .scene = "nothing", .parameters = parameters});
  CHECK(end_of(result.outcome) == "touch 1");
  CHECK(std::abs(way_along_z(result)) < 0.1);
  const auto read_first = run({.skill = "touch-read-first", .scene = "nothing", .parameters = parameters});
  CHECK(end_of(read_first.outcome) == "touch-read-first 1");
  CHECK(std::abs(way_along_z(read_first)) < 0.1);
}

TEST_CASE("touch: the forearm hits a bar, completion 2, in both orders") {
  const auto result = run({.skill = "touch", .scene = "bar-under-forearm"});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "touch 2");
  CHECK(stands_still(result));
  const auto read_first = run({.skill = "touch-read-first", .scene = "bar-under-forearm"});
  CHECK(end_of(read_first.outcome) == "touch-read-first 2");
  CHECK(stands_still(read_first));
}

TEST_CASE("touch, rub: a motion that comes too late ends the skill, completion 2") {
  // Line 55 of touch.pal and 75 of rub.pal: the read that a motion is decided on. Its motions are dropped.
  const std::vector<runtime::ParameterValue> near{{"reach", 10}};
  const auto late = run(
      {.skill = "touch", .scene = "nothing", .parameters = near, .fault = "at 300 ms SM1:55 takes 40 ms"});
  CAPTURE(late.outcome.reason);
  CHECK(end_of(late.outcome) == "touch 2");
  CHECK(late.outcome.reason.find("a step is missing") != std::string::npos);
  CHECK(way_along_z(late) > 3);  // what it had gone after 300 ms at 20 mm/s: it goes neither on nor back
  CHECK(way_along_z(late) < 8);
  CHECK(stands_still(late));
  const auto rub = run({.skill = "rub",
                        .scene = "touch",
                        .parameters = {{"distance", 2}},
                        .raise = -14,
                        .fault = "at 2 s SM1:75 takes 40 ms"});
  CAPTURE(rub.outcome.reason);
  CHECK(end_of(rub.outcome) == "rub 2");
  CHECK(stands_still(rub));
}

TEST_CASE("touch says that nothing was met only when the tool does not press") {
  // The plate is 15 mm below. At these reaches the last motion ends below, on and in it.
  for (const double reach : {14.5, 15.0, 15.2, 15.4, 15.6, 16.0, 17.0}) {
    const auto result =
        run({.skill = "touch", .scene = "touch", .parameters = {{"reach", reach}, {"approach-speed", 20}}});
    CAPTURE(reach, result.peak_force, result.resting_force, result.outcome.reason);
    REQUIRE_FALSE(result.outcome.fault);
    if (result.outcome.code == 0) {
      CHECK(result.resting_force > 4);  // the noise of the sensor and of its sampling
    } else {
      CHECK(result.peak_force < 6);
      CHECK(std::abs(way_along_z(result)) < 0.1);
    }
  }
}

TEST_CASE("touch: a speed that overloads the sensor is refused before anything moves") {
  const auto result =
      run({.skill = "touch", .scene = "touch", .parameters = {{"approach-speed", 60}, {"threshold", 40}}});
  CHECK(result.outcome.fault);
  CHECK(end_of(result.outcome) == "touch 2");
  CHECK(result.outcome.duration == runtime::Time::zero());
  CHECK(result.outcome.reason.find("at 60 mm/s a contact of 11 N/mm is felt too late") == 0);
  CHECK(result.outcome.reason.find("it may go at 27.1 mm/s") != std::string::npos);
  CHECK(std::abs(way_along_z(result)) < 0.05);
  // At the speed that it names the sensor is not overloaded.
  const auto slower =
      run({.skill = "touch", .scene = "touch", .parameters = {{"approach-speed", 27.1}, {"threshold", 40}}});
  CHECK(end_of(slower.outcome) == "touch 0");
  CHECK(slower.peak_force < 65);
}

TEST_CASE("press holds the force, completion 0") {
  const auto result =
      run({.skill = "press", .scene = "plate-5", .parameters = {{"force", 8}, {"time", 0.5}}});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "press 0");
  CHECK(result.outcome.overruns == 0);
  CHECK(pressing(result).back() == Approx(8).margin(0.5));
}

TEST_CASE("press meets nothing and goes back, completion 1") {
  const auto result = run({.skill = "press",
                           .scene = "nothing",
                           .parameters = {{"search-distance", 10}, {"approach-speed", 20}}});
  CHECK(end_of(result.outcome) == "press 1");
  CHECK(result.peak_force == 0);
  CHECK(std::abs(way_along_z(result)) < 0.1);
}

TEST_CASE("press meets the stop force and lifts off, completion 2") {
  const auto result = run({.skill = "press",
                           .scene = "touch",
                           .parameters = {{"force", 5}, {"stop-force", 7}, {"approach-speed", 25}}});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "press 2");
  CHECK(result.peak_force >= 7);
  CHECK(result.resting_force == 0);
  CHECK(way_along_z(result) <
        13);  // 5 mm up from where nothing was felt any more; it pressed 15 to 18 mm below the start
  CHECK(way_along_z(result) > 7);
}

TEST_CASE("press holds the force for ten seconds, in which it drifts, completion 0") {
  const auto result = run({.skill = "press", .scene = "touch", .parameters = {{"force", 5}, {"time", 10}}});
  CAPTURE(result.outcome.reason);
  REQUIRE(end_of(result.outcome) == "press 0");
  const auto forces = pressing(result);
  const double end = std::chrono::duration<double>(result.outcome.duration).count();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const double when = std::chrono::duration<double>(result.log[i].time).count();
    if (when < end - 10 || when > end) continue;
    REQUIRE(std::abs(forces[i] - 5) < 0.4);
  }
}

TEST_CASE("press refuses a force that would be the stop force, completion 3") {
  const auto result = run({.skill = "press", .scene = "touch", .parameters = {{"force", 40}}});
  CHECK(result.outcome.fault);
  CHECK(end_of(result.outcome) == "press 3");
  CHECK(result.outcome.reason == "force must be less than stop-force");
  CHECK(result.outcome.duration == runtime::Time::zero());
}

TEST_CASE("press gives up after 30 s outside its band, completion 3") {
  // Told a stiffness of a twentieth of what is there: each try leads far over the force.
  const auto result = run({.skill = "press",
                           .scene = "plate-20",
                           .parameters = {{"force", 5}, {"band", 0.2}, {"time", 6}, {"stiffness", 0.5}}});
  CHECK(end_of(result.outcome) == "press 3");
  CHECK(result.outcome.reason.find("the force does not stay in its band") != std::string::npos);
  CHECK(result.outcome.duration > std::chrono::seconds(36));
  CHECK(result.outcome.duration < std::chrono::seconds(45));
  CHECK(stands_still(result));
}

TEST_CASE("rub: the surface ends, completion 2, and the tool stands in the air beside it") {
  const auto result = run({.skill = "rub",
                           .scene = "sponge",
                           .parameters = {{"direction", 90}, {"distance", 20}, {"speed", 0.8}}});
  CHECK(end_of(result.outcome) == "rub 2");
  CHECK(result.outcome.reason.find("the surface has ended: nothing was felt for 140 ms") !=
        std::string::npos);
  CHECK(result.resting_force == 0);
  const auto& last = result.log.back();
  CHECK((last.tool - result.log[result.log.size() - 100].tool).norm() < 5e-5);
}

TEST_CASE("rub goes the whole distance, completion 0, by both regulators") {
  const double band_rule = GENERATE(0.0, 1.0);
  const auto result = run(
      {.skill = "rub",
       .scene = "touch",
       .parameters =
           {{"distance", 2}, {"direction", 90}, {"speed", 0.5}, {"vertical", 0.15}, {"band-rule", band_rule}},
       .raise = -14});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "rub 0");
  CHECK((result.log.back().tool - result.log.front().tool).head<2>().norm() * 1e3 == Approx(20).margin(0.2));
  CHECK(result.resting_force > 1);
  CHECK(result.resting_force < 9);
}

TEST_CASE("rub hits a step and lifts off, completion 1") {
  const auto result = run({.skill = "rub",
                           .scene = "low-step",
                           .parameters = {{"speed", 1}, {"stop-force", 300}, {"distance", 12}},
                           .raise = -13});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "rub 1");
  const double along = (result.log.back().tool - result.log.front().tool).x() * 1e3;
  CHECK(along > 45);
  CHECK(along < 75);
  double lowest = 1e9;
  for (const sim::Sample& sample : result.log) lowest = std::min(lowest, sample.tool.z());
  CHECK((result.log.back().tool.z() - lowest) * 1e3 > 4);
}

TEST_CASE("rub that has met a step lifts off until the tool leans on nothing, completion 1") {
  // Another machine, another height: here the tool leaned on the side of the block with 22 N.
  sim::CellOptions options;
  options.seed = 5;
  options.machine_seed = 5;
  options.raise = 0.52;
  Workshop shop(scene("step"), options);
  CHECK(end_of(shop.run("rub")) == "rub 1");
  CHECK(shop.log().back().contact_force == 0);
}

TEST_CASE("rub meets the error force and stands still, completion 2") {
  const auto result =
      run({.skill = "rub",
           .scene = "low-step",
           .parameters = {{"speed", 1}, {"stop-force", 300}, {"error-force", 300}, {"distance", 12}},
           .raise = -13});
  CAPTURE(result.outcome.reason);
  CHECK_FALSE(result.outcome.fault);
  CHECK(end_of(result.outcome) == "rub 2");
  CHECK(result.peak_force > 10);
}

TEST_CASE("rub refuses limits that contradict each other") {
  const auto reason = [](std::vector<runtime::ParameterValue> parameters) {
    return run({.skill = "rub", .scene = "touch", .parameters = std::move(parameters)}).outcome.reason;
  };
  CHECK(reason({{"greatest-force", -30}, {"least-force", -170}}) ==
        "greatest-force must be below least-force: both are negative when the tool presses");
  CHECK(reason({{"stop-force", 100}}) == "stop-force must be greater than the band's greatest force");
  CHECK(reason({{"error-force", 600}}) == "error-force must not be less than stop-force");
  CHECK(reason({{"speed", 0}}) == "speed must be greater than 0: the distance would never be gone");
  CHECK(reason({{"vertical", 0}}) ==
        "vertical must be greater than 0: the tool would never come to the surface");
  CHECK(reason({{"band-rule", 1}, {"least-force", -150}, {"vertical", 1}, {"stiffness", 25}})
            .find("at 35.7143 mm/s a contact of 25 N/mm is felt too late") == 0);
}
