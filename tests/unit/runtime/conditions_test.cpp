// Conditions: when they are read, and what a latch does.
#include <catch2/catch.hpp>

#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::Task;
using runtime::Thread;

TEST_CASE("a test uses the latched value once and reads the others at its effect") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int q = skill.processor("Q");
  const int c = skill.condition("c");
  const int d = skill.condition("d");
  const int read = skill.statement("RPC( c )", 1ms);
  const int set = skill.statement("SPC", 2ms);
  const int test = skill.statement("CASE", 4ms);
  const int end = skill.statement("end");
  std::vector<bool> seen;
  skill.thread("A", p, 1, [&](Thread& t) -> Task {
    co_await t.read(read, c);
    co_await t.test(test, c, d);
    seen.insert(seen.end(), {t.tested(c), t.tested(d)});
    co_await t.test(test, c);
    seen.push_back(t.tested(c));
    co_await t.complete(end, 0);
  });
  skill.thread("B", q, 1, [&](Thread& t) -> Task {
    co_await t.set(set, c, true);
    co_await t.set(set, d, [] { return true; });
    co_await t.set(set, c, false);
  });
  const auto outcome = run(skill);
  CHECK(only(to_text(outcome.trace), {"set", "read"}) ==
        "1 read A RPC( c ) c=0\n"
        "2 set B SPC c=1\n"
        "4 set B SPC d=1\n"
        "5 read A CASE d=1\n"
        "6 set B SPC c=0\n"
        "9 read A CASE c=0\n");
  CHECK(seen == std::vector<bool>{false, true, false});
}

TEST_CASE("conditions are FALSE when a skill starts, also for the second time") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int c = skill.condition("c");
  const int statement = skill.statement("s");
  std::vector<bool> seen;
  skill.thread("A", p, 1, [&](Thread& t) -> Task {
    co_await t.test(statement, c);
    seen.push_back(t.tested(c));
    co_await t.set(statement, c, true);
    co_await t.complete(statement, 0);
  });
  run(skill);
  run(skill);
  CHECK(seen == std::vector<bool>{false, false});
}
