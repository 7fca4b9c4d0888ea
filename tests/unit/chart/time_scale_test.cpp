// From time to place, and the ticks of the axis.
#include <catch2/catch.hpp>

#include "analyzer/chart/detail.hpp"
#include "analyzer/chart/time_scale.hpp"

namespace pal::analyzer::chart {
namespace {

std::vector<std::string> labels(const Ticks& ticks) {
  std::vector<std::string> result;
  for (const Tick& tick : ticks.major) result.push_back(tick.label);
  return result;
}

TEST_CASE("a linear scale maps its ends to its ends and the rest in proportion") {
  const TimeScale scale({{10, 30}}, 100, 500, 50);
  CHECK(scale.x(10) == 100);
  CHECK(scale.x(20) == 300);
  CHECK(scale.x(30) == 500);
  CHECK(scale.x(5) == 100);
  CHECK(scale.x(99) == 500);
}

TEST_CASE("a folded scale draws its windows in one scale, with folds between them") {
  const TimeScale scale({{0, 10}, {1000, 1030}}, 0, 450, 50);
  CHECK(scale.x(10) == 100);
  CHECK(scale.x(1000) == 150);
  CHECK(scale.x(1030) == 450);
  CHECK(scale.width(10) == 100);
  CHECK(scale.shows(10));
  CHECK_FALSE(scale.shows(500));
  CHECK(scale.touches(500, 1000));
  CHECK_FALSE(scale.touches(11, 999));
  REQUIRE(scale.pieces().size() == 3);
  CHECK(scale.pieces()[1].folded);
  CHECK(scale.widest(80, 400).x0 == 150);
  CHECK(scale.widest(80, 400).x1 == 400);
}

TEST_CASE("ticks are round, far enough apart, in the unit that fits") {
  const auto of = [](std::int64_t from, std::int64_t to, std::int64_t zero = 0) {
    return ticks(TimeScale({{from, to}}, 0, 10000, 0), zero);
  };
  CHECK(labels(of(0, 40'000'000)) ==
        std::vector<std::string>{"0", "5", "10", "15", "20", "25", "30", "35", "40"});
  CHECK(of(0, 40'000'000).unit == "ms");
  CHECK(labels(of(1'100'000, 2'300'000)).front() == "1.1");
  CHECK(of(0, 50'000).unit == "\u00b5s");
  CHECK(of(0, 60'000'000'000).unit == "s");
  CHECK(labels(of(0, 10'000'000, 5'000'000)).front() == "\u22125");
  CHECK(labels(of(0, 1)).size() >= 1);
}

TEST_CASE("ticks are never closer than their labels need, over twelve orders of magnitude") {
  for (std::int64_t length = 1; length < 1'000'000'000'000; length = length * 3 + 1) {
    const TimeScale scale({{length / 7, length / 7 + length}}, 0, 9800, 0);
    const Ticks found = ticks(scale, 0);
    for (std::size_t i = 1; i < found.major.size(); ++i) {
      REQUIRE(scale.x(found.major[i].at_ns) - scale.x(found.major[i - 1].at_ns) >= 600);
    }
  }
}

}  // namespace

TEST_CASE("a scale of weeks is as even as one of milliseconds") {
  const std::int64_t week = std::int64_t{7} * 24 * 3600 * 1'000'000'000;
  const TimeScale scale({{0, 40 * week}}, 0, 8'000, 0);
  CHECK(scale.x(10 * week) == 2'000);
  CHECK(scale.x(30 * week) == 6'000);
  CHECK(scale.width(40 * week) == 8'000);
}

}  // namespace pal::analyzer::chart
