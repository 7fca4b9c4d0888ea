#include "analyzer/compositional/times/transaction.hpp"

#include <catch2/catch.hpp>

using namespace pal::analyzer::compositional;
using pal::analyzer::Nanoseconds;

TEST_CASE("a closed window of a whole period has two releases") {
  CHECK(releases(10, 0, 9) == 1);
  CHECK(releases(10, 0, 10) == 2);
}

TEST_CASE("release jitter brings more releases to a window") {
  CHECK(releases(10, 4, 5) == 1);
  CHECK(releases(10, 4, 6) == 2);
  CHECK(releases(10, 25, 5) == 4);
}

TEST_CASE("what occurs once is released once, however long the window") {
  CHECK(releases(never, 5, 1'000) == 1);
}

TEST_CASE("releases have no bound if the jitter has none") {
  CHECK(releases(10, never, 1) == never);
}

TEST_CASE("the next release after the scenario's comes within a period") {
  Transaction of;
  of.period = 10;
  Task task;
  task.offset = 2;
  task.jitter = 1;
  CHECK(phase(of, task, 2) == 9);   // the same task: a period later, less its jitter
  CHECK(phase(of, task, 7) == 4);   // a later one of the same occurrence
  CHECK(phase(of, task, 3) == 10);  // one whose release the scenario just misses
}

TEST_CASE("alternatives bring the longest of them once an occurrence") {
  Transaction of;
  of.period = 10;
  for (const Nanoseconds cost : {2, 3}) {
    Task task;
    task.cost = cost;
    of.tasks.push_back(task);
  }
  std::vector<Share> shares;
  Tally apart(of, TransactionId{0}, &shares);
  apart.add(TaskId{0}, 4);
  apart.add(TaskId{1}, 4);
  CHECK(apart.total([](const Alternatives&) { return Nanoseconds{4}; }) == 20);

  of.exclude({TaskId{0}, TaskId{1}}, 0);
  Tally together(of, TransactionId{0}, nullptr);
  together.add(TaskId{0}, 4);
  together.add(TaskId{1}, 4);
  CHECK(together.total([](const Alternatives&) { return Nanoseconds{4}; }) == 12);
}
