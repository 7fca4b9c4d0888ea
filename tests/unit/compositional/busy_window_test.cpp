// Busy windows without anything of PAL: task sets whose response times can be worked out by hand.
#include "analyzer/compositional/times/busy_window.hpp"

#include <catch2/catch.hpp>

using pal::analyzer::ProcessorId;
using namespace pal::analyzer::compositional;
using pal::analyzer::Nanoseconds;

namespace {

Transaction periodic(Nanoseconds period, Nanoseconds cost, int priority) {
  Transaction of;
  of.period = period;
  of.regular = true;
  Task task;
  task.cost = cost;
  task.priority = priority;
  of.tasks.push_back(task);
  return of;
}

/// Tasks (cost 1, period 4), (2, 6) and (3, 10), the first with the greatest priority.
BusyWindows three_tasks(bool preemptive) {
  BusyWindows windows({preemptive});
  windows.add(periodic(4, 1, 3));
  windows.add(periodic(6, 2, 2));
  windows.add(periodic(10, 3, 1));
  return windows;
}

}  // namespace

TEST_CASE("response times of three periodic tasks are those of the recurrence") {
  const BusyWindows windows = three_tasks(true);
  CHECK(windows.finish(TransactionId{0}, TaskId{0}, 1, 0) == 1);
  CHECK(windows.finish(TransactionId{1}, TaskId{0}, 2, 0) == 3);
  CHECK(windows.finish(TransactionId{2}, TaskId{0}, 3, 0) == 10);
}

TEST_CASE("without preemption, work of lower priority blocks once") {
  const BusyWindows windows = three_tasks(false);
  CHECK(windows.finish(TransactionId{0}, TaskId{0}, 1, 3) == 4);
}

TEST_CASE("in a half-open window the release at its end does not count") {
  const auto finish = [](WindowEnds ends, bool preemptive) {
    BusyWindows windows({preemptive}, {}, ends);
    windows.add(periodic(4, 2, 2));
    windows.add(periodic(100, 2, 1));
    const FinishBreakdown parts = windows.breakdown(TransactionId{1}, TaskId{0}, 2, 0);
    Nanoseconds sum = 2 + parts.blocking - parts.done_before;
    for (const Share& share : parts.others) sum += share.work;
    const Nanoseconds found = windows.finish(TransactionId{1}, TaskId{0}, 2, 0);
    CHECK(sum == found);
    return found;
  };
  // 2 + 2: the next one comes at 4, as this ends.
  CHECK(finish(WindowEnds::closed, true) == 6);
  CHECK(finish(WindowEnds::half_open, true) == 4);
  // Without preemption the one that comes as this would begin goes first: windows stay closed.
  CHECK(finish(WindowEnds::half_open, false) == finish(WindowEnds::closed, false));
}

TEST_CASE("work that takes no time waits for what is released with it, also in a half-open window") {
  BusyWindows windows({true}, {}, WindowEnds::half_open);
  windows.add(periodic(10, 3, 2));
  windows.add(periodic(20, 1, 1));
  CHECK(windows.finish(TransactionId{1}, TaskId{0}, 0, 0) == 3);
}

TEST_CASE("an overloaded processor has no busy window") {
  BusyWindows windows({true});
  windows.add(periodic(4, 3, 2));
  windows.add(periodic(6, 2, 1));
  CHECK(windows.finish(TransactionId{1}, TaskId{0}, 2, 0) == never);
  CHECK(windows.busy(ProcessorId{0}) == never);
}

TEST_CASE("release jitter of one task delays another by one more job") {
  BusyWindows windows({true});
  windows.add(periodic(10, 2, 2));
  windows.add(periodic(20, 5, 1));
  CHECK(windows.finish(TransactionId{1}, TaskId{0}, 5, 0) == 7);
  windows.set_jitter(TransactionId{0}, TaskId{0}, 4, never);
  CHECK(windows.finish(TransactionId{1}, TaskId{0}, 5, 0) == 9);
}

TEST_CASE("what does not count for a task does not delay it") {
  BusyWindows windows({true});
  windows.add(periodic(10, 2, 2));
  windows.add(periodic(20, 5, 1));
  windows.set_without(TransactionId{1}, TaskId{0}, {{TransactionId{0}, TaskId{0}}});
  CHECK(windows.finish(TransactionId{1}, TaskId{0}, 5, 0) == 5);
}

TEST_CASE("the breakdown of a finish adds up to it") {
  const BusyWindows windows = three_tasks(true);
  const FinishBreakdown parts = windows.breakdown(TransactionId{2}, TaskId{0}, 3, 0);
  Nanoseconds sum = 3 + parts.blocking - parts.done_before;
  for (const Share& share : parts.others) sum += share.work;
  CHECK(sum == windows.finish(TransactionId{2}, TaskId{0}, 3, 0));
}

TEST_CASE("the longest busy period is the first instant at which all work is done") {
  // 1 + 3 at 0, then 1 at 4: done at 5.
  BusyWindows windows({true});
  windows.add(periodic(4, 1, 2));
  windows.add(periodic(10, 3, 1));
  CHECK(windows.busy(ProcessorId{0}) == 5);
}

namespace {

/// Tasks of cost 44 and 31, one after the other, with priorities 2 and 1, and one of 68 above them.
BusyWindows two_stages(Nanoseconds jitter) {
  Transaction chain = periodic(1000, 44, 2);
  Task second;
  second.cost = 31;
  second.priority = 1;
  second.offset = 44;
  chain.tasks.push_back(second);
  BusyWindows windows({true});
  windows.add(chain);
  windows.add(periodic(1000, 68, 3));
  windows.set_jitter(TransactionId{0}, TaskId{0}, jitter, never);
  windows.set_jitter(TransactionId{0}, TaskId{1}, jitter + 68, never);
  return windows;
}

}  // namespace

TEST_CASE("tasks that follow one another at once are delayed once together") {
  const BusyWindows windows = two_stages(0);
  CHECK(windows.finish(TransactionId{0}, TaskId{1}, 31, 0) == 211);
  CHECK(windows.joint_finish(TransactionId{0}, {TaskId{0}, TaskId{1}}, 31) == 143);
  CHECK(windows.joint_finish(TransactionId{0}, {TaskId{0}, TaskId{1}}, 11) == 123);
  const auto shares = windows.joint_breakdown(TransactionId{0}, {TaskId{0}, TaskId{1}}, 31);
  REQUIRE(shares.size() == 1);
  CHECK(shares[0].transaction == TransactionId{1});
  CHECK(shares[0].work == 68);
}

TEST_CASE("no joint bound if the next occurrence may come before the window ends") {
  CHECK(two_stages(856).joint_finish(TransactionId{0}, {TaskId{0}, TaskId{1}}, 31) == 143);
  CHECK(two_stages(857).joint_finish(TransactionId{0}, {TaskId{0}, TaskId{1}}, 31) == never);
}

TEST_CASE("without preemption, tasks have no joint bound") {
  BusyWindows windows({false});
  windows.add(periodic(1000, 44, 2));
  CHECK(windows.joint_finish(TransactionId{0}, {TaskId{0}}, 44) == never);
}
