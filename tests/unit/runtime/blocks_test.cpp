// CONCURRENT: when it ends, and how a block that cannot end is cancelled.
#include <catch2/catch.hpp>

#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::from;
using runtime::Task;
using runtime::Thread;

namespace {

// SM waits in CONCURRENT for block 2, which works for 5 ms; block 1 is the test's.
struct Fork {
  explicit Fork(WrittenSkill::Body forever) {
    const int p = skill.processor("P");
    const int q = skill.processor("Q");
    r = skill.processor("R");
    const int five = skill.statement("five", 5ms);
    const int fork = skill.statement("CONCURRENT");
    const int after = skill.statement("after", 4ms);
    const int end = skill.statement("end");
    skill.thread("SM", p, 1, [=](Thread& t) -> Task {
      co_await t.concurrent(fork, 1, 2);
      co_await t.perform(after, [] {});
      co_await t.complete(end, 0);
    });
    skill.block("SM.1", 0, q, 1, false, std::move(forever));
    skill.block("SM.2", 0, p, 1, true, [=](Thread& t) -> Task { co_await t.perform(five, [] {}); });
  }
  WrittenSkill skill;
  int r = 0;
};

}  // namespace

TEST_CASE("a block that waits is stopped at once and its open request is withdrawn") {
  int request = -1;
  int x = -1;
  int send = -1;
  int receive = -1;
  Fork fork([&](Thread& t) -> Task {
    for (;;) {
      co_await t.send(send, request);
      co_await t.wait(receive, from(x));
    }
  });
  request = fork.skill.channel("SM", "request x", "LS");
  x = fork.skill.channel("LS", "x", "SM");
  fork.skill.channels[0].answer = x;
  send = fork.skill.statement("send");
  receive = fork.skill.statement("receive");
  const int work = fork.skill.statement("work", 3ms);
  const int answer = fork.skill.statement("answer");
  fork.skill.thread("LS", fork.r, 1, [&](Thread& t) -> Task {
    for (;;) {
      co_await t.wait(receive, from(request));
      co_await t.perform(work, [] {});
      co_await t.send(answer, x);
    }
  });
  CHECK(only(to_text(run(fork.skill).trace), {"cancel", "drop", "take SM.1", "start SM after"}) ==
        "3 take SM.1 receive <x>\n"
        "5 cancel SM.1 receive\n"
        "5 start SM after\n"
        "6 drop LS answer <x>\n");
}

TEST_CASE("a cancelled block finishes its activity before the parent goes on") {
  int work = -1;
  int set = -1;
  int c = -1;
  Fork fork([&](Thread& t) -> Task {
    for (;;) {
      co_await t.perform(work, [] {});
      co_await t.set(set, c, true);
    }
  });
  work = fork.skill.statement("work", 8ms);
  set = fork.skill.statement("set");
  c = fork.skill.condition("c");
  CHECK(only(to_text(run(fork.skill).trace), {"SM.1", "after", "SM block"}) ==
        "0 start SM.1 work\n"
        "8 done SM.1 work\n"
        "8 cancel SM.1 work\n"
        "8 start SM after\n"
        "12 done SM after\n");
}

TEST_CASE("a send to a full slot is given up when its block is cancelled") {
  int x = -1;
  int send = -1;
  Fork fork([&](Thread& t) -> Task {
    for (;;) co_await t.send(send, x);
  });
  x = fork.skill.channel("SM", "x", "LS");
  send = fork.skill.statement("send", 3ms);
  const int wait = fork.skill.statement("wait");
  const int sleep = fork.skill.statement("sleep", 7ms);
  fork.skill.thread("LS", fork.r, 1, [&](Thread& t) -> Task {
    co_await t.perform(sleep, [] {});
    for (;;) co_await t.wait(wait, from(x));
  });
  CHECK(only(to_text(run(fork.skill).trace), {"SM.1", "take"}) ==
        "0 start SM.1 send\n"
        "3 put SM.1 send <x>\n"
        "3 done SM.1 send\n"
        "3 start SM.1 send\n"
        "6 cancel SM.1 send\n"
        "7 take LS wait <x>\n");
}

TEST_CASE("without blocks that cannot end, CONCURRENT ends with the last, and may begin again") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int q = skill.processor("Q");
  const int fork = skill.statement("CONCURRENT");
  const int two = skill.statement("two", 2ms);
  const int three = skill.statement("three", 3ms);
  const int end = skill.statement("end");
  skill.thread("SM", p, 1, [=](Thread& t) -> Task {
    co_await t.concurrent(fork, 1, 2);
    co_await t.concurrent(fork, 1, 2);
    co_await t.complete(end, 0);
  });
  skill.block("SM.1", 0, p, 1, true, [=](Thread& t) -> Task { co_await t.perform(two, [] {}); });
  skill.block("SM.2", 0, q, 1, true, [=](Thread& t) -> Task { co_await t.perform(three, [] {}); });
  const auto outcome = run(skill);
  CHECK(outcome.duration == 6ms);
  CHECK(only(to_text(outcome.trace), {"done SM."}) ==
        "2 done SM.1 two\n"
        "3 done SM.2 three\n"
        "5 done SM.1 two\n"
        "6 done SM.2 three\n");
}

TEST_CASE("cancelling a block stops the blocks inside it") {
  int inner = -1;
  int work = -1;
  int wait = -1;
  int x = -1;
  Fork fork([&](Thread& t) -> Task {
    for (;;) co_await t.concurrent(inner, 3, 4);
  });
  inner = fork.skill.statement("INNER");
  work = fork.skill.statement("work", 3ms);
  wait = fork.skill.statement("wait");
  x = fork.skill.channel("LS", "x", "SM");
  fork.skill.block("SM.1.1", 1, fork.r, 1, true, [&](Thread& t) -> Task { co_await t.wait(wait, from(x)); });
  fork.skill.block("SM.1.2", 1, fork.r, 1, true, [&](Thread& t) -> Task {
    co_await t.perform(work, [] {});
    co_await t.perform(work, [] {});
  });
  CHECK(only(to_text(run(fork.skill).trace), {"cancel", "after"}) ==
        "5 cancel SM.1.1 wait\n"
        "6 cancel SM.1.2 work\n"
        "6 cancel SM.1 INNER\n"
        "6 start SM after\n"
        "10 done SM after\n");
}
