// Standoff and align: each way in which they end.
#include <catch2/catch.hpp>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/seam.hpp"

using namespace pal;
using namespace pal::test;

namespace {

/// From the tip along the tool's axis to a plane through `point` (mm) with this normal.
double standoff(const sim::Sample& at, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d axis = at.tool_turn * Eigen::Vector3d::UnitZ();
  return normal.dot(point - at.tool * 1e3) / normal.dot(axis);
}

/// Requests of ALTER that the skill had no motion for, after its first motion.
int motions_not_made(const trace::Trace& run) {
  bool moves = false;
  int count = 0;
  for (const trace::Event& event : run.events) {
    if (event.kind != trace::Kind::done) continue;
    const std::string& text = run.statements[static_cast<std::size_t>(event.statement)].text;
    moves = moves || text == "obey";
    if (moves && text == "hold") ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("standoff comes to the distance, from above and from below, completion 0") {
  const double distance = GENERATE(170.0, 260.0);
  const auto result =
      run({.skill = "standoff", .scene = "flat", .parameters = {{"distance", distance}, {"speed", 2}}});
  CAPTURE(result.outcome.reason);
  REQUIRE(end_of(result.outcome) == "standoff 0");
  // The plate is 15 mm high and its underside is at -120 mm.
  const double reached = standoff(result.log.back(), {480, -200, -105}, Eigen::Vector3d::UnitZ());
  CHECK(reached == Approx(distance).margin(0.4));
}

TEST_CASE("standoff and align: nothing in range, completion 1, the tool stands still") {
  const auto standoff = run({.skill = "standoff", .scene = "nothing-in-view"});
  CHECK(end_of(standoff.outcome) == "standoff 1");
  CHECK((standoff.log.back().tool - standoff.log.front().tool).norm() < 1e-4);
  const auto align = run({.skill = "align", .scene = "nothing-in-view"});
  CHECK(end_of(align.outcome) == "align 1");
  CHECK((align.log.back().tool - align.log.front().tool).norm() < 1e-4);
}

TEST_CASE("align stands square to a plate that leans about both axes, completion 0") {
  const auto result = run({.skill = "align", .scene = "tilted", .parameters = {{"tolerance", 0.1}}});
  CAPTURE(result.outcome.reason);
  REQUIRE(end_of(result.outcome) == "align 0");
  const double degree = 3.14159265358979 / 180;
  const Eigen::Vector3d normal = Eigen::AngleAxisd(12 * degree, Eigen::Vector3d::UnitX()) *
                                 Eigen::AngleAxisd(5 * degree, Eigen::Vector3d::UnitY()) *
                                 Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d axis = result.log.back().tool_turn * Eigen::Vector3d::UnitZ();
  CHECK(std::acos(std::min(1.0, -axis.dot(normal))) / degree < 0.15);
}

TEST_CASE("align refuses what is not flat, completion 1") {
  const auto result = run({.skill = "align", .scene = "pyramid"});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "align 1");
}

TEST_CASE("standoff ends with its error completion where there is no range finder") {
  const auto result = run({.skill = "standoff", .scene = "touch"});
  CHECK(end_of(result.outcome) == "standoff 2");
  CHECK((result.log.back().tool - result.log.front().tool).norm() < 1e-4);
}

TEST_CASE(
    "standoff, align and follow-edge: the range finder is unplugged on the way, completion 2, and the tool "
    "stands still") {
  const std::string fault = "at 1200 ms range-finder unplug";
  const auto stopped = [](const workcell::SessionResult& result) {
    const auto& last = result.log.back();
    const double moved = (last.tool - result.log.front().tool).norm() +
                         last.tool_turn.angularDistance(result.log.front().tool_turn);
    return moved > 1e-3 && (last.tool - result.log[result.log.size() - 100].tool).norm() < 1e-5;
  };
  const auto standoff = run({.skill = "standoff", .scene = "flat", .fault = fault});
  CHECK(end_of(standoff.outcome) == "standoff 2");
  CHECK(standoff.outcome.reason == "range-finder: the link is broken: unplugged");
  CHECK((standoff.log.back().tool - standoff.log[standoff.log.size() - 100].tool).norm() < 1e-5);
  const auto align = run({.skill = "align", .scene = "tilted", .fault = fault});
  CHECK(end_of(align.outcome) == "align 2");
  CHECK(stopped(align));
  const auto follow = run({.skill = "follow-edge", .scene = "seam", .fault = fault});
  CHECK(end_of(follow.outcome) == "follow-edge 2");
  CHECK(stopped(follow));
}

namespace {

// What the range finder looks at from the standoff of 200 mm, mm.
Eigen::Vector3d at_edge(const sim::Sample& sample) {
  return 1e3 * (sample.tool + sample.tool_turn * Eigen::Vector3d(0, 0, 0.2));
}

}  // namespace

TEST_CASE("follow-edge goes the distance, completion 0") {
  const auto result =
      run({.skill = "follow-edge", .scene = "seam", .parameters = {{"distance", 3}, {"track", 0.6}}});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "follow-edge 0");
  CHECK((at_edge(result.log.back()) - at_edge(result.log.front())).x() == Approx(30).margin(3));
}

TEST_CASE("follow-edge makes up for motions that came too late, and goes the distance") {
  // Line 72 of follow_edge.pal is `track`. So slow, its motion is late whenever LS2 is at work.
  const auto end_with = [](const std::string& fault, int& not_made) {
    const auto result = run({.skill = "follow-edge",
                             .scene = "seam",
                             .parameters = {{"distance", 6}, {"track", 0.6}},
                             .fault = fault});
    CAPTURE(result.outcome.reason);
    CHECK(end_of(result.outcome) == "follow-edge 0");
    not_made = motions_not_made(result.outcome.trace);
    return at_edge(result.log.back());
  };
  int usually = 0, slowly = 0;
  const Eigen::Vector3d usual = end_with("", usually);
  const Eigen::Vector3d slow = end_with("at 0 ms SM1:72 takes 3.6 ms", slowly);
  CHECK(slowly >= usually + 5);  // 3 mm of the way
  CHECK((slow - usual).norm() < 0.5);
}

TEST_CASE(
    "follow-edge keeps to its edge at 30 mm/s with its usual limits, and nearer than the thesis's law") {
  const Seam seam;
  const auto off_edge = [&](double literal) {
    const auto result = run({.skill = "follow-edge",
                             .scene = "seam-wide",
                             .parameters = {{"track", 0.84}, {"distance", 12}, {"literal", literal}}});
    CHECK(result.outcome.code == 0);
    double squares = 0, count = 0;
    for (const sim::Sample& sample : result.log) {
      if (sample.time > result.outcome.duration || (at_edge(sample) - at_edge(result.log.front())).x() < 40)
        continue;
      squares += std::pow(off(seam, sample, 200).length, 2);
      ++count;
    }
    return std::sqrt(squares / count);
  };
  const double ours = off_edge(0);
  CHECK(ours < 0.5);  // 8 to 20 mm when it turned about the range finder
  CHECK(ours < off_edge(1));
}

TEST_CASE("follow-edge refuses a history in which it would see too little of the edge") {
  const auto result = run({.skill = "follow-edge", .scene = "seam", .parameters = {{"track", 3}}});
  CHECK(end_of(result.outcome) == "follow-edge 2");
  CHECK(result.outcome.duration == runtime::Time::zero());
  CHECK(result.outcome.reason ==
        "at 3 mm in 28 ms the edge is seen every 8.4 mm: history must be 12.6 mm or more, or the edge's "
        "direction is not "
        "known");
}

TEST_CASE("follow-edge without an edge stands still, completion 1") {
  const auto result = run({.skill = "follow-edge", .scene = "flat"});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "follow-edge 1");
  CHECK((result.log.back().tool - result.log.front().tool).norm() < 1e-3);
}

TEST_CASE("follow-edge: the edge ends, completion 1, and the tool stands still beyond it") {
  const double rotation = GENERATE(0.1, 0.5);  // with 0.5 the tool can turn to what it sees beside the end
  CAPTURE(rotation);
  const auto result = run({.skill = "follow-edge",
                           .scene = "seam-end",
                           .parameters = {{"distance", 15}, {"track", 0.8}, {"rotation", rotation}}});
  CAPTURE(result.outcome.reason);
  CHECK(end_of(result.outcome) == "follow-edge 1");
  const double gone = (at_edge(result.log.back()) - at_edge(result.log.front())).x();
  CHECK(gone > 60);  // the edge ends after 80 mm, and the range finder is held square to it
  CHECK(gone < 110);
  CHECK((result.log.back().tool - result.log[result.log.size() - 100].tool).norm() < 1e-5);
}
