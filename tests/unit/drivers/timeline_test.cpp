// The clock of a station.
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "runtime/drivers/timeline.hpp"

namespace pal::runtime::drivers {
namespace {

using namespace std::chrono_literals;

TEST_CASE("actions run in the order of their instants, then in the order of asking", "[timeline]") {
  Timeline timeline;
  std::string order;
  timeline.at(2ms, [&] { order += "c"; });
  timeline.at(1ms, [&] { order += "a"; });
  timeline.at(1ms, [&] { order += "b"; });
  REQUIRE(timeline.next() == 1ms);
  timeline.advance_to(1500us);
  REQUIRE(order == "ab");
  REQUIRE(timeline.now() == 1500us);
  timeline.advance_to(2ms);
  REQUIRE(order == "abc");
  REQUIRE(timeline.next() == Timeline::never);
}

TEST_CASE("an action may ask for another one of the same instant", "[timeline]") {
  Timeline timeline;
  int calls = 0;
  timeline.at(1ms, [&] { timeline.after(0ms, [&] { ++calls; }); });
  timeline.advance_to(1ms);
  REQUIRE(calls == 1);
}

TEST_CASE("a cancelled action is not called, and a late cancel hits no other action", "[timeline]") {
  Timeline timeline;
  int calls = 0;
  const auto first = timeline.at(1ms, [&] { calls += 1; });
  timeline.cancel(first);
  timeline.at(1ms, [&] { calls += 10; });  // takes the place of the first
  timeline.cancel(first);
  timeline.advance_to(2ms);
  timeline.cancel(first);
  REQUIRE(calls == 10);
}

TEST_CASE("an action in the past is refused", "[timeline]") {
  Timeline timeline;
  timeline.advance_to(5ms);
  REQUIRE_THROWS_AS(timeline.at(4ms, [] {}), std::logic_error);
}

TEST_CASE("an action that throws leaves the others in place", "[timeline]") {
  Timeline timeline;
  int calls = 0;
  timeline.at(1ms, [] { throw std::runtime_error("no"); });
  timeline.at(2ms, [&] { ++calls; });
  REQUIRE_THROWS_AS(timeline.advance_to(3ms), std::runtime_error);
  REQUIRE(timeline.now() == 1ms);
  timeline.advance_to(3ms);
  REQUIRE(calls == 1);
}

}  // namespace
}  // namespace pal::runtime::drivers
