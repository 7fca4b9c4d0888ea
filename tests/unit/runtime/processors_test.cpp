// Processors: the runs are worked out by hand from docs/reference/execution-model.md.
#include <catch2/catch.hpp>

#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::Task;
using runtime::Thread;

namespace {

// A long job of low priority; another thread waits for a message and then wants the processor.
struct Interrupted {
  explicit Interrupted(bool preemptive, int urgent_priority) {
    const int p = skill.processor("P", preemptive);
    const int q = skill.processor("Q");
    const int go = skill.channel("Clock", "go", "Urgent");
    const int long_job = skill.statement("long-job", 10ms);
    const int end = skill.statement("end");
    const int count = skill.statement("count", 3ms);
    const int send = skill.statement("TXM go");
    const int wait = skill.statement("WTM go", 1ms);
    const int short_job = skill.statement("short-job", 2ms);
    skill.thread("Long", p, 1, [=](Thread& t) -> Task {
      co_await t.perform(long_job, [] {});
      co_await t.complete(end, 0);
    });
    skill.thread("Urgent", p, urgent_priority, [=](Thread& t) -> Task {
      co_await t.wait(wait, runtime::from(go));
      co_await t.perform(short_job, [] {});
    });
    skill.thread("Clock", q, 1, [=](Thread& t) -> Task {
      co_await t.perform(count, [] {});
      co_await t.send(send, go);
    });
  }
  WrittenSkill skill;
};

}  // namespace

TEST_CASE("a thread of greater priority takes a preemptive processor at once") {
  Interrupted bench(true, 2);
  const runtime::Outcome outcome = run(bench.skill);
  CHECK(outcome.code == 0);
  CHECK(only(to_text(outcome.trace), {"Long", "Urgent"}) ==
        "0 block Urgent WTM go\n"
        "0 start Long long-job\n"
        "3 stop Long long-job\n"
        "3 start Urgent WTM go\n"
        "4 take Urgent WTM go <go>\n"
        "4 done Urgent WTM go\n"
        "4 start Urgent short-job\n"
        "6 done Urgent short-job\n"
        "6 start Long long-job\n"
        "13 done Long long-job\n"
        "13 start Long end\n"
        "13 complete Long end 0\n"
        "13 done Long end\n");
}

TEST_CASE("without preemption a thread waits until the running one blocks or ends") {
  Interrupted bench(false, 2);
  CHECK(only(to_text(run(bench.skill).trace), {"Long", "Urgent"}) ==
        "0 block Urgent WTM go\n"
        "0 start Long long-job\n"
        "3 ready Urgent WTM go\n"
        "10 done Long long-job\n"
        "10 start Long end\n"
        "10 complete Long end 0\n"
        "10 done Long end\n");
}

TEST_CASE("a thread of equal priority does not interrupt") {
  Interrupted bench(true, 1);
  CHECK(only(to_text(run(bench.skill).trace), {"Urgent"}) ==
        "0 block Urgent WTM go\n"
        "3 ready Urgent WTM go\n");
}

TEST_CASE("equals are first come, first served, and an interrupted thread goes first") {
  // A runs from 0 and is interrupted at 2 by H, which runs for 1; B, ready since 0, comes after A.
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int q = skill.processor("Q");
  const int go = skill.channel("Clock", "go", "H");
  const int four = skill.statement("four", 4ms);
  const int two = skill.statement("two", 2ms);
  const int one = skill.statement("one", 1ms);
  const int send = skill.statement("send");
  const int wait = skill.statement("wait");
  const int end = skill.statement("end");
  skill.thread("A", p, 1, [=](Thread& t) -> Task { co_await t.perform(four, [] {}); });
  skill.thread("B", p, 1, [=](Thread& t) -> Task {
    co_await t.perform(four, [] {});
    co_await t.complete(end, 0);
  });
  skill.thread("H", p, 5, [=](Thread& t) -> Task {
    co_await t.wait(wait, runtime::from(go));
    co_await t.perform(one, [] {});
  });
  skill.thread("Clock", q, 1, [=](Thread& t) -> Task {
    co_await t.perform(two, [] {});
    co_await t.send(send, go);
  });
  const runtime::Outcome outcome = run(skill);
  CHECK(only(to_text(outcome.trace), {"A four", "B four", "H one"}) ==
        "0 start A four\n"
        "0 ready B four\n"
        "2 stop A four\n"
        "2 start H one\n"
        "3 done H one\n"
        "3 start A four\n"
        "5 done A four\n"
        "5 start B four\n"
        "9 done B four\n");
  CHECK(outcome.duration == 9ms);
}

TEST_CASE("a thread keeps its processor from one statement to the next") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int one = skill.statement("one", 1ms);
  const int end = skill.statement("end");
  skill.thread("A", p, 1, [=](Thread& t) -> Task {
    co_await t.perform(one, [] {});
    co_await t.perform(one, [] {});
  });
  skill.thread("B", p, 1, [=](Thread& t) -> Task {
    co_await t.perform(one, [] {});
    co_await t.complete(end, 0);
  });
  CHECK(only(to_text(run(skill).trace), {"done"}) ==
        "1 done A one\n"
        "2 done A one\n"
        "3 done B one\n"
        "3 done B end\n");
}

TEST_CASE("costs are the worst, the best, or random by seed") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int work = skill.statement("work", {1ms, 5ms});
  const int end = skill.statement("end");
  skill.thread("A", p, 1, [=](Thread& t) -> Task {
    for (int i = 0; i < 10; ++i) co_await t.perform(work, [] {});
    co_await t.complete(end, 0);
  });
  CHECK(run(skill, {}, {.costs = runtime::CostPolicy::worst}).duration == 50ms);
  CHECK(run(skill, {}, {.costs = runtime::CostPolicy::best}).duration == 10ms);
  const auto first = run(skill, {}, {.costs = runtime::CostPolicy::random, .seed = 1});
  CHECK(first.duration > 10ms);
  CHECK(first.duration < 50ms);
  CHECK(run(skill, {}, {.costs = runtime::CostPolicy::random, .seed = 1}).trace.events == first.trace.events);
  CHECK(run(skill, {}, {.costs = runtime::CostPolicy::random, .seed = 2}).trace.events != first.trace.events);
}
