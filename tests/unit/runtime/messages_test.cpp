// Channels: one slot, latency, waits that give up, the first of several.
#include <catch2/catch.hpp>

#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::from;
using runtime::Task;
using runtime::Thread;

namespace {

struct Number {
  double value = 0;
  static constexpr std::size_t field_count = 1;
  std::array<double, 1> fields() const { return {value}; }
  static Number from_fields(std::span<const double> fields) { return {fields[0]}; }
};
constexpr runtime::Field number_fields[] = {{"value", ""}};

// Two threads with a processor each.
struct Pair {
  Pair() {
    p = skill.processor("P");
    q = skill.processor("Q");
    send = skill.statement("send");
    receive = skill.statement("receive");
    work = skill.statement("work", 10ms);
    nap = skill.statement("nap", 1ms);
    end = skill.statement("end");
  }
  WrittenSkill skill;
  int p = 0, q = 0, send = 0, receive = 0, work = 0, nap = 0, end = 0;
};

}  // namespace

TEST_CASE("a message keeps its fields, and a second send waits for a free slot") {
  Pair pair;
  const int x = pair.skill.channel("A", "x", "B");
  pair.skill.channels[0].fields = number_fields;
  Number out;
  std::vector<double> got;
  pair.skill.thread("A", pair.p, 1, [&](Thread& t) -> Task {
    for (int i = 1; i <= 3; ++i) {
      out.value = i;
      co_await t.send(pair.send, x, out);
    }
  });
  Number in;
  pair.skill.thread("B", pair.q, 1, [&](Thread& t) -> Task {
    for (int i = 0; i < 3; ++i) {
      co_await t.perform(pair.work, [] {});
      co_await t.wait(pair.receive, from(x, in));
      got.push_back(in.value);
    }
    co_await t.complete(pair.end, 0);
  });
  const auto outcome = run(pair.skill);
  CHECK(got == std::vector<double>{1, 2, 3});
  CHECK(only(to_text(outcome.trace), {"block", "put", "take"}) ==
        "0 put A send <x>\n"
        "0 block A send\n"
        "10 take B receive <x>\n"
        "10 put A send <x>\n"
        "10 block A send\n"
        "20 take B receive <x>\n"
        "20 put A send <x>\n"
        "30 take B receive <x>\n");
}

TEST_CASE("a message is available after its latency, sooner within a processor") {
  Pair pair;
  pair.skill.latency = {{1ms, 1ms}, {4ms, 4ms}};
  const int x = pair.skill.channel("A", "x", "B");
  const int y = pair.skill.channel("A", "y", "C");
  pair.skill.thread("A", pair.p, 1, [&](Thread& t) -> Task {
    co_await t.send(pair.send, x);
    co_await t.send(pair.send, y);
  });
  pair.skill.thread("B", pair.q, 1, [&](Thread& t) -> Task {
    co_await t.wait(pair.receive, from(x));
    co_await t.complete(pair.end, 0);
  });
  pair.skill.thread("C", pair.p, 1, [&](Thread& t) -> Task { co_await t.wait(pair.receive, from(y)); });
  CHECK(only(to_text(run(pair.skill).trace), {"take"}) ==
        "1 take C receive <y>\n"
        "4 take B receive <x>\n");
}

TEST_CASE("the slot is full until the effect of the take") {
  Pair pair;
  const int x = pair.skill.channel("A", "x", "B");
  const int slow = pair.skill.statement("slow-receive", 5ms);
  pair.skill.thread("A", pair.p, 1, [&](Thread& t) -> Task {
    co_await t.send(pair.send, x);
    co_await t.send(pair.send, x);
  });
  pair.skill.thread("B", pair.q, 1, [&](Thread& t) -> Task {
    co_await t.wait(slow, from(x));
    co_await t.complete(pair.end, 0);
  });
  CHECK(only(to_text(run(pair.skill).trace), {"put", "take"}) ==
        "0 put A send <x>\n"
        "5 take B slow-receive <x>\n"
        "5 put A send <x>\n");
}

TEST_CASE("a wait within a time takes what comes in time and gives up otherwise") {
  const auto wait_ms = GENERATE(0, 9, 11);
  Pair pair;
  pair.skill.test = {2ms, 2ms};
  const int x = pair.skill.channel("A", "x", "B");
  int taken = -2;
  pair.skill.thread("A", pair.p, 1, [&](Thread& t) -> Task {
    co_await t.perform(pair.work, [] {});
    co_await t.send(pair.send, x);
  });
  pair.skill.thread("B", pair.q, 1, [&](Thread& t) -> Task {
    taken = co_await t.wait_within(pair.receive, std::chrono::milliseconds(wait_ms), from(x));
    co_await t.complete(pair.end, 0);
  });
  const auto outcome = run(pair.skill);
  if (wait_ms == 11) {
    CHECK(taken == 0);
    CHECK(outcome.duration == 10ms);
  } else {
    CHECK(taken == -1);
    CHECK(outcome.duration == std::chrono::milliseconds(wait_ms) + 2ms);
  }
}

TEST_CASE("WTM FIRST takes from the first channel in the text that has a message") {
  Pair pair;
  const int x = pair.skill.channel("A", "x", "B");
  const int y = pair.skill.channel("A", "y", "B");
  std::vector<int> taken;
  pair.skill.thread("A", pair.p, 1, [&](Thread& t) -> Task {
    co_await t.send(pair.send, x);
    co_await t.send(pair.send, y);
    co_await t.perform(pair.work, [] {});
    co_await t.send(pair.send, x);
  });
  pair.skill.thread("B", pair.q, 1, [&](Thread& t) -> Task {
    co_await t.perform(pair.nap, [] {});
    for (int i = 0; i < 3; ++i) taken.push_back(co_await t.wait(pair.receive, from(y), from(x)));
    co_await t.complete(pair.end, 0);
  });
  CHECK(run(pair.skill).duration == 10ms);
  CHECK(taken == std::vector<int>{0, 1, 1});
}

namespace {

// B asks A for x every 10 ms and waits only 1 ms for it; what A does in between is the case.
struct Withdrawal : Pair {
  Withdrawal() {
    request = skill.channel("B", "request x", "A");
    x = skill.channel("A", "x", "B");
    skill.channels[static_cast<std::size_t>(request)].answer = x;
  }
  void add_client(int rounds) {
    skill.thread("B", q, 1, [this, rounds](Thread& t) -> Task {
      for (int i = 0; i < rounds; ++i) {
        co_await t.send(send, request);
        taken.push_back(co_await t.wait_within(receive, 1ms, from(x)));
        co_await t.perform(work, [] {});
      }
      co_await t.complete(end, 0);
    });
  }
  int request = 0, x = 0;
  std::vector<int> taken;
};

}  // namespace

TEST_CASE("a request that is withdrawn while it is in its slot is removed") {
  Withdrawal bench;
  const int late = bench.skill.statement("late", 5ms);
  const int take = bench.skill.statement("take-request");
  const int answer = bench.skill.statement("answer");
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    co_await t.perform(late, [] {});
    for (;;) {
      co_await t.wait(take, from(bench.request));
      co_await t.send(answer, bench.x);
    }
  });
  bench.add_client(2);
  const auto text = to_text(run(bench.skill).trace);
  CHECK(bench.taken == std::vector<int>{-1, 0});
  CHECK(only(text, {"drop", "take A", "put A"}) ==
        "1 drop <request x>\n"
        "11 take A take-request <request x>\n"
        "11 put A answer <x>\n");
}

TEST_CASE("the answer to a request that was withdrawn after its take is discarded") {
  Withdrawal bench;
  const int slow = bench.skill.statement("slow", 5ms);
  const int take = bench.skill.statement("take-request");
  const int answer = bench.skill.statement("answer");
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    co_await t.wait(take, from(bench.request));
    co_await t.perform(slow, [] {});
    co_await t.send(answer, bench.x);
    for (;;) {
      co_await t.wait(take, from(bench.request));
      co_await t.send(answer, bench.x);
    }
  });
  bench.add_client(2);
  CHECK(only(to_text(run(bench.skill).trace), {"drop", "put A"}) ==
        "5 drop A answer <x>\n"
        "11 put A answer <x>\n");
  CHECK(bench.taken == std::vector<int>{-1, 0});
}

TEST_CASE("an answer that is on its way is removed") {
  Withdrawal bench;
  bench.skill.latency.between_processors = {3ms, 3ms};
  const int take = bench.skill.statement("take-request");
  const int answer = bench.skill.statement("answer");
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    for (;;) {
      co_await t.wait(take, from(bench.request));
      co_await t.send(answer, bench.x);
    }
  });
  bench.skill.thread("B", bench.q, 1, [&](Thread& t) -> Task {
    co_await t.send(bench.send, bench.request);
    bench.taken.push_back(co_await t.wait_within(bench.receive, 4ms, from(bench.x)));
    co_await t.perform(bench.work, [] {});
    bench.taken.push_back(co_await t.wait_within(bench.receive, 0ms, from(bench.x)));
    co_await t.complete(bench.end, 0);
  });
  CHECK(only(to_text(run(bench.skill).trace), {"drop", "put A", "give_up"}) ==
        "3 put A answer <x>\n"
        "4 give_up B receive <x>\n"
        "4 drop <x>\n"
        "14 give_up B receive <x>\n");
}

TEST_CASE("a receive that loses its message to a withdrawal waits again") {
  Withdrawal bench;
  const int slow_take = bench.skill.statement("slow-take", 2ms);
  const int answer = bench.skill.statement("answer");
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    for (;;) {
      co_await t.wait(slow_take, from(bench.request));
      co_await t.send(answer, bench.x);
    }
  });
  bench.add_client(1);
  CHECK(only(to_text(run(bench.skill).trace), {" A ", "drop"}) ==
        "0 block A slow-take\n"
        "0 start A slow-take\n"
        "1 drop <request x>\n"
        "2 block A slow-take\n");
}
