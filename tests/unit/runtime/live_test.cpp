// Live events: a ring between a run and its viewer.
#include <catch2/catch.hpp>
#include <thread>

#include "pal/runtime/trace_ring.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::from;
using runtime::Task;
using runtime::Thread;
using runtime::TraceMode;
using runtime::TraceRing;

namespace {

trace::Event event(std::int64_t number) {
  return {number, trace::Kind::put, 0, 0, 0, 0};
}

trace::Events all_of(TraceRing& ring) {
  trace::Events result(ring.capacity());
  result.resize(ring.take(result));
  return result;
}

// Two threads that send each other a number of messages.
struct Talk {
  explicit Talk(int count) {
    const int p = skill.processor("P");
    const int there = skill.channel("A", "there", "B"), back = skill.channel("B", "back", "A");
    const int put = skill.statement("put", 1us), get = skill.statement("get", 1us);
    skill.thread("A", p, 1, [=](Thread& t) -> Task {
      for (int i = 0; i < count; ++i) {
        co_await t.send(put, there);
        co_await t.wait(get, from(back));
      }
      co_await t.complete(put, 0);
    });
    skill.thread("B", p, 2, [=](Thread& t) -> Task {
      for (;;) {
        co_await t.wait(get, from(there));
        co_await t.send(put, back);
      }
    });
  }
  WrittenSkill skill;
};

}  // namespace

TEST_CASE("a ring keeps the order, events that find it full are dropped and counted") {
  TraceRing ring(3);
  REQUIRE(ring.capacity() == 4);
  for (int i = 0; i < 6; ++i) ring.put(event(i));
  CHECK(ring.dropped() == 2);
  std::array<trace::Event, 3> room;
  REQUIRE(ring.take(room) == 3);
  CHECK(room[2] == event(2));
  ring.put(event(6));
  CHECK(all_of(ring) == trace::Events{event(3), event(6)});
  CHECK(all_of(ring).empty());
}

TEST_CASE("an observer gets the events of the trace, also if the run keeps none") {
  for (const TraceMode mode : {TraceMode::all, TraceMode::last, TraceMode::none}) {
    Talk expected(20), live(20);
    TraceRing ring(1024);
    const auto outcome = run(live.skill, {}, {.trace = mode, .trace_capacity = 5, .live = &ring});
    CHECK(outcome.code == 0);
    CHECK(ring.dropped() == 0);
    CHECK(all_of(ring) == run(expected.skill).trace.events);
  }
}

TEST_CASE("a trace that outgrows its room many times is whole, its end and its file have the same events") {
  const auto traced = [](runtime::RunOptions options) {
    Talk talk(10'000);
    const auto outcome = run(talk.skill, {}, options);
    CHECK(outcome.code == 0);
    return outcome.trace.events;
  };
  TraceRing ring(1U << 18U);
  const trace::Events all = traced({.trace_capacity = 1, .live = &ring});
  REQUIRE(all.size() > 100'000);
  CHECK(ring.dropped() == 0);
  CHECK((all == all_of(ring)));  // not printed: there are too many
  for (const std::size_t capacity : {4095U, 4096U, 5000U, 70'000U}) {
    const trace::Events last = traced({.trace = TraceMode::last, .trace_capacity = capacity});
    REQUIRE(last.size() == capacity);
    CHECK(std::equal(last.begin(), last.end(), all.end() - static_cast<std::ptrdiff_t>(capacity)));
    trace::EventSpool spool;
    CHECK(traced({.trace_capacity = capacity, .spool = &spool}).empty());
    trace::Events spooled;
    spool.for_each([&spooled](const trace::Event& event) { spooled.push_back(event); });
    CHECK((spooled == all));
  }
}

TEST_CASE("a reader that does not read costs events, and changes nothing of the run") {
  Talk plain(200), live(200);
  TraceRing ring(64);
  const auto expected = run(plain.skill);
  const auto outcome = run(live.skill, {}, {.live = &ring});
  CHECK(outcome.trace.events == expected.trace.events);
  CHECK(ring.dropped() == expected.trace.events.size() - 64);
}

TEST_CASE("a reader in another thread gets everything that is not dropped, in order") {
  constexpr std::int64_t count = 200'000;
  TraceRing ring(256);
  std::thread writer([&ring] {
    for (std::int64_t i = 0; i < count; ++i) ring.put(event(i));
  });
  std::int64_t got = 0, last = -1;
  bool in_order = true;
  std::array<trace::Event, 32> room;
  const auto look = [&] {
    const std::size_t taken = ring.take(room);
    for (std::size_t i = 0; i < taken; ++i) {
      in_order = in_order && room[i].time_ns > last && room[i] == event(room[i].time_ns);
      last = room[i].time_ns;
    }
    got += static_cast<std::int64_t>(taken);
    return taken > 0;
  };
  while (got + static_cast<std::int64_t>(ring.dropped()) < count) look();
  writer.join();
  while (look()) {
  }
  CHECK(in_order);
  CHECK(got + static_cast<std::int64_t>(ring.dropped()) == count);
}
