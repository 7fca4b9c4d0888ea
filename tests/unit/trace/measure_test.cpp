// What a run attained, read off its trace.
#include <catch2/catch.hpp>

#include "pal/trace/age_meter.hpp"
#include "pal/trace/loss_meter.hpp"
#include "pal/trace/measure.hpp"

namespace pal::trace {
namespace {

/// A thread that hears a bell, asks a meter, and rings back when it has the answer.
Trace asking(Events events) {
  Trace trace;
  trace.actors = {{"A", false, "P0", 1}, {"bell", true, "", 0}, {"meter", true, "", 0}};
  trace.statements = {{"A", "TXM( back to bell )", "asking.pal", 9}};
  trace.channels = {
      {"bell", "ring", "A"}, {"A", "request value", "meter"}, {"meter", "value", "A"}, {"A", "back", "bell"}};
  trace.events = std::move(events);
  return trace;
}

constexpr std::int32_t ring = 0;
constexpr std::int32_t request = 1;
constexpr std::int32_t value = 2;

/// Two rings and a request for each; the second waits in its slot until the meter is done with the first.
const Events two_requests = {
    {0, Kind::put, 1, -1, ring, 1},  {1, Kind::take, 0, -1, ring, 1},     {2, Kind::put, 0, -1, request, 1},
    {2, Kind::busy, 2, -1, -1, 0},   {2, Kind::take, 2, -1, request, 1},  {5, Kind::put, 1, -1, ring, 2},
    {6, Kind::take, 0, -1, ring, 2}, {7, Kind::put, 0, -1, request, 2},   {10, Kind::idle, 2, -1, -1, 0},
    {10, Kind::busy, 2, -1, -1, 0},  {10, Kind::take, 2, -1, request, 2},
};

Responses responses_after(Events rest) {
  Events events = two_requests;
  events.insert(events.end(), rest.begin(), rest.end());
  return responses(asking(std::move(events)), "bell", "ring", {{"A", "TXM( back to bell )", 9}});
}

TEST_CASE("an answer carries the event of its own request, not of the next") {
  const Responses found = responses_after({
      {10, Kind::put, 2, -1, value, 1},
      {11, Kind::take, 0, -1, value, 1},
      {12, Kind::done, 0, 0, -1, 0},
  });
  REQUIRE(found.answered.size() == 1);
  CHECK(found.answered[0] == Occurrence{0, 12, 0, 0});
  CHECK(found.missed == 0);
}

TEST_CASE("a request whose answer is lost or discarded is answered") {
  const Kind kind = GENERATE(Kind::overrun, Kind::drop);
  const Responses found = responses_after({
      {10, kind, 2, -1, value, 1},
      {18, Kind::idle, 2, -1, -1, 0},
      {18, Kind::put, 2, -1, value, 2},
      {19, Kind::take, 0, -1, value, 2},
      {20, Kind::done, 0, 0, -1, 0},
  });
  REQUIRE(found.answered.size() == 1);
  CHECK(found.answered[0] == Occurrence{5, 20, 0, 0});
  CHECK(found.missed == 1);
}

/// The age of the meter's value at the thread's statement, as the events show it.
std::int64_t age_of_value(const Events& events) {
  const Trace tables = asking({});
  Marks channels(tables.channels.size()), at(tables.statements.size());
  channels[value] = at[0] = true;
  SampleMeter meter(SampleFlow(tables, channels), at);
  std::int64_t age = -1;
  for (const Event& event : events)
    if (const auto seen = meter.see(event, -1)) age = seen->length_ns();
  return age;
}

TEST_CASE("a sample's age counts from when its request reached the device, also if it is never busy") {
  CHECK(age_of_value({{2, Kind::put, 0, -1, request, 1},
                      {2, Kind::busy, 2, -1, -1, 0},
                      {2, Kind::take, 2, -1, request, 1},
                      {7, Kind::idle, 2, -1, -1, 0},
                      {7, Kind::put, 2, -1, value, 1},
                      {8, Kind::take, 0, -1, value, 1},
                      {9, Kind::done, 0, 0, -1, 0}}) == 7);
  CHECK(age_of_value({{2, Kind::put, 0, -1, request, 1},
                      {7, Kind::take, 2, -1, request, 1},
                      {7, Kind::put, 2, -1, value, 1},
                      {8, Kind::take, 0, -1, value, 1},
                      {9, Kind::done, 0, 0, -1, 0}}) == 7);
  // It serves one after the other.
  CHECK(age_of_value({{2, Kind::put, 0, -1, request, 1},
                      {7, Kind::take, 2, -1, request, 1},
                      {7, Kind::put, 2, -1, value, 1},
                      {7, Kind::put, 0, -1, request, 2},
                      {7, Kind::take, 0, -1, value, 1},
                      {12, Kind::take, 2, -1, request, 2},
                      {12, Kind::put, 2, -1, value, 2},
                      {13, Kind::take, 0, -1, value, 2},
                      {14, Kind::done, 0, 0, -1, 0}}) == 7);
}

TEST_CASE("an answer that nobody asked for shifts no sample and is no loss") {
  CHECK(age_of_value({{2, Kind::put, 0, -1, request, 1},
                      {2, Kind::busy, 2, -1, -1, 0},
                      {2, Kind::take, 2, -1, request, 1},
                      {3, Kind::drop, 2, -1, value, unasked},
                      {7, Kind::idle, 2, -1, -1, 0},
                      {7, Kind::put, 2, -1, value, 1},
                      {8, Kind::take, 0, -1, value, 1},
                      {9, Kind::done, 0, 0, -1, 0}}) == 7);
  const Trace tables = asking({});
  LossMeter losses(tables, 2, LossMeter::Of::answers, 2, 0);
  losses.see({2, Kind::take, 2, -1, request, 1});
  CHECK_FALSE(losses.see({3, Kind::drop, 2, -1, value, unasked}));
  CHECK(losses.see({7, Kind::put, 2, -1, value, 1}) == 0);
  losses.see({8, Kind::take, 2, -1, request, 2});
  CHECK_FALSE(losses.see({9, Kind::drop, 2, -1, value, no_answer}));
  losses.see({9, Kind::take, 2, -1, request, 3});
  CHECK(losses.see({12, Kind::drop, 2, -1, value, 7}) == 1);
}

TEST_CASE("frames that nobody asked for are lost, from the first one that answered on") {
  const Trace tables = asking({});
  const auto frame = [&tables](LossMeter& losses, std::int64_t at, bool marks) {
    if (marks) losses.see({at, Kind::busy, 2, -1, -1, 0});
    losses.see({at, Kind::take, 2, -1, request, 1});
    if (marks) losses.see({at + 2, Kind::idle, 2, -1, -1, 0});
    return losses.see({at + 2, Kind::put, 2, -1, value, 1});
  };
  SECTION("a device that says when it is busy") {
    LossMeter losses(tables, 2, LossMeter::Of::frames, 3, 10);
    losses.see({0, Kind::busy, 2, -1, -1, 0});
    CHECK_FALSE(losses.see({2, Kind::idle, 2, -1, -1, 0}));  // none has answered before
    CHECK(frame(losses, 10, true) == 0);
    losses.see({20, Kind::busy, 2, -1, -1, 0});
    CHECK(losses.see({22, Kind::idle, 2, -1, -1, 0}) == 1);
    losses.see({30, Kind::busy, 2, -1, -1, 0});
    CHECK(losses.see({32, Kind::idle, 2, -1, -1, 0}) == 2);
  }
  SECTION("one that does not: the time between two tells it") {
    LossMeter losses(tables, 2, LossMeter::Of::frames, 3, 10);
    frame(losses, 10, false);
    CHECK(frame(losses, 41, false) == 2);
    frame(losses, 50, false);
    CHECK(losses.finish() == 0);
  }
}

}  // namespace
}  // namespace pal::trace
