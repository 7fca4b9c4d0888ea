// A trace regrouped by actor.
#include <catch2/catch.hpp>

#include "pal/trace/slices.hpp"

namespace pal::trace {
namespace {

Trace two_actors(Events events) {
  Trace trace;
  trace.actors = {{"SM1", false, "P0", 1}, {"force-torque", true, "", 0}};
  trace.statements = {{"SM1", "WTM( Zforce from LS1 )", "touch.pal", 3}, {"SM1", "advance", "touch.pal", 4}};
  trace.channels = {{"LS1", "Zforce", "SM1"}};
  trace.events = std::move(events);
  return trace;
}

TEST_CASE("a wait, a receive and an activity that is preempted") {
  const auto found = slices(two_actors({
      {0, Kind::block, 0, 0, 0, 0},
      {10, Kind::ready, 0, 0, -1, 0},
      {12, Kind::start, 0, 0, -1, 0},
      {15, Kind::take, 0, 0, 0, 1},
      {15, Kind::done, 0, 0, -1, 0},
      {15, Kind::start, 0, 1, -1, 0},
      {18, Kind::stop, 0, 1, -1, 0},
      {25, Kind::start, 0, 1, -1, 0},
      {30, Kind::done, 0, 1, -1, 0},
  }));
  REQUIRE(found.size() == 6);
  CHECK(found[0] == Slice{0, State::waiting, Ending::over, 0, 0, 0, 10});
  CHECK(found[1] == Slice{0, State::ready, Ending::over, 0, -1, 10, 12});
  CHECK(found[2] == Slice{0, State::running, Ending::effect, 0, -1, 12, 15});
  CHECK(found[3] == Slice{0, State::running, Ending::preempted, 1, -1, 15, 18});
  CHECK(found[4] == Slice{0, State::ready, Ending::over, 1, -1, 18, 25});
  CHECK(found[5] == Slice{0, State::running, Ending::effect, 1, -1, 25, 30});
}

TEST_CASE("a wait that gives up, and one that is cancelled") {
  const auto found = slices(two_actors({
      {0, Kind::block, 0, 0, 0, 0},
      {4, Kind::give_up, 0, 0, 0, 0},
      {4, Kind::start, 0, 0, -1, 0},
      {5, Kind::done, 0, 0, -1, 0},
      {5, Kind::block, 0, 0, 0, 0},
      {9, Kind::cancel, 0, -1, -1, 0},
  }));
  REQUIRE(found.size() == 3);
  CHECK(found[0].ending == Ending::gave_up);
  CHECK(found[1] == Slice{0, State::running, Ending::effect, 0, -1, 4, 5});
  CHECK(found[2].ending == Ending::cancelled);
  CHECK(found[2].to_ns == 9);
}

TEST_CASE("a statement that costs nothing still has its effect") {
  const auto found = slices(two_actors({{7, Kind::start, 0, 1, -1, 0}, {7, Kind::done, 0, 1, -1, 0}}));
  REQUIRE(found.size() == 1);
  CHECK(found[0] == Slice{0, State::running, Ending::effect, 1, -1, 7, 7});
}

TEST_CASE("an effect without a start is an action of no length") {
  const auto found = slices(two_actors({{2, Kind::block, 0, 1, 0, 0}, {7, Kind::done, 0, 1, -1, 0}}));
  REQUIRE(found.size() == 2);
  CHECK(found[0] == Slice{0, State::waiting, Ending::over, 1, 0, 2, 7});
  CHECK(found[1] == Slice{0, State::running, Ending::effect, 1, -1, 7, 7});
}

TEST_CASE("a send that finds its slot full runs, then waits") {
  const auto found = slices(two_actors({
      {0, Kind::start, 0, 1, -1, 0},
      {1, Kind::block, 0, 1, 0, 0},
      {9, Kind::put, 0, 1, 0, 3},
      {9, Kind::done, 0, 1, -1, 0},
  }));
  REQUIRE(found.size() == 3);
  CHECK(found[0].ending == Ending::blocked);
  CHECK(found[1].state == State::waiting);
  CHECK(found[2].ending == Ending::effect);
}

TEST_CASE("slices that last until the trace ends are open") {
  const auto found = slices(two_actors({{3, Kind::busy, 1, -1, -1, 0}, {8, Kind::complete, 0, 1, -1, 0}}));
  REQUIRE(found.size() == 1);
  CHECK(found[0] == Slice{1, State::serving, Ending::open, -1, -1, 3, 8});
}

}  // namespace
}  // namespace pal::trace
