// Unusual programs, each with what docs/reference/execution-model.md says of it, worked out
// by hand.
#include "analyzer/analysis.hpp"
#include "tests/differential/by_hand.hpp"
#include "tests/support/any_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::bound;
using pal::test::meaningful_skill;
using pal::test::program;

namespace {

Verdict first_verdict(const std::string& name) {
  return analyze_exactly(*meaningful_skill(program(name))->problem).verdicts.front();
}

}  // namespace

TEST_CASE("a CONCURRENT after one that ended by cancelling is waited for") {
  // The first is over at 1 ms, the second 5 ms later: the value of c, from the start, is 6 ms old then.
  CHECK(bound(program("hand/after_cancelling")) == 6);
}

TEST_CASE("a block behind blocks that were stopped is not over when another one ends") {
  // All but the first block of the inner CONCURRENT, and the second one of the outer, is over at once: SM1.1
  // thinks for 3 ms.
  CHECK(bound(program("hand/behind_stopped")) == 3);
}

TEST_CASE("WITHIN 0 ms may miss the message of a sender that the thread itself has freed") {
  // SM1 is always blocked in its send. The first wait of MC1 frees the slot and leads to the second, at one
  // instant with the send. So the second may miss the message, and hold for 3 ms.
  CHECK(bound(program("hand/only_looks")) == 3);
}

TEST_CASE("a module's first blocks join their queues in any order with other modules") {
  // SM1's block (3 ms), MC1 (1 ms) and no other thread are on P: c, from the start, is 4 ms old if MC1 was
  // first.
  CHECK(bound(program("hand/begins_with_blocks")) == 4);
}

TEST_CASE("a value that goes to and fro for long is followed all the way") {
  // SM1 and MC1 play for 100 ms, a hit a millisecond, after MC1 has read c at 0.
  CHECK(bound(program("hand/long_way")) == 100);
}

TEST_CASE("times near the limit do not overflow") {
  // The condition is set once, before a loop without end: its age has no bound.
  const Verdict verdict = first_verdict("hand/near_the_limit");
  INFO(verdict.explanation.text());
  CHECK_FALSE(verdict.bound);
  CHECK(verdict.state != Verdict::State::holds);
}

TEST_CASE("the exploration ends although a thread is interrupted for ever") {
  // SM1 interrupts MC1 1 ms after that has begun to obey, and never lets it go on.
  CHECK(bound(program("hand/starved")) == 1);
  CHECK(bound(program("hand/starved_unevenly")) == 3);
}

TEST_CASE("an interrupted thread that interrupts another still owes it its time") {
  // MC1.1 obeys from 0; SM1.1 interrupts it at 1 for 5 ms, and is interrupted at 4 by MC1.2 for up to 2.
  // MC1.1 has its last millisecond from 8 on.
  CHECK(bound(program("hand/interrupted_twice")) == 9);
}

TEST_CASE("a cancelled block withdraws its own requests, and not its parent's") {
  // The block asks at 1 ms, and is cancelled at 3; the answer to its parent comes at 5.
  CHECK(bound(program("hand/takes_back_its_own")) == 5);
}

TEST_CASE("requests that are open when a block ends are withdrawn with its parent") {
  // The inner block has asked at 0, its parent is stopped at 1: the answer of 5 ms is discarded, and the next
  // request answered at 10.
  CHECK(bound(program("hand/taken_back_with_parent")) == 10);
}

TEST_CASE("of two requests that were taken the one that was withdrawn is not answered") {
  // Both are taken at 0, the second is withdrawn at 2. Of the answers at 5 one is put; the next message comes
  // at 10.
  CHECK(bound(program("hand/withdrawn_of_two")) == 10);
}

TEST_CASE("a request whose answer was lost is not open any more") {
  // The device answers at 1 and, into the full slot, at 2: that one is lost. After both waits nothing is
  // open, so the answer to the third request is not discarded: it comes 1 ms after 7.
  CHECK(bound(program("hand/lost_answer")) == 8);
}

TEST_CASE("one instant: the parent of a stopped block, and a sender freed by a withdrawal") {
  // At 2 ms the answer to the block is withdrawn, and the second message of SM1 put. Then SM1 and MC1 come to
  // P: if MC1 is first it holds for 1 ms, and SM1 has thought from 3 to 8.
  CHECK(bound(program("hand/parent_of_stopped")) == 8);
}

TEST_CASE("load of another processor: a thread that never gets its own processor") {
  // MC2 never gives P0 to SM1, which would complete the skill at once; P1 is busy with MC1 all the time.
  const Verdict verdict = first_verdict("hand/waits_for_ever");
  CHECK(verdict.state == Verdict::State::fails);
  CHECK(verdict.exact);
  CHECK(verdict.bound == Duration(1'000'000'000));
}

TEST_CASE("where time may stand still no requirement holds, even after an early stop") {
  // MC1 and SM1 hand the one message on at one instant, for as long as c stays FALSE.
  const auto skill = meaningful_skill(program("hand/stands_still"));
  int asked = 0;
  for (int most = 0; most < 40; ++most) {
    asked = 0;
    Options options;
    options.threads = 1;
    options.stop = [&asked, most] { return ++asked > most; };
    const Analysis analysis = analyze(*skill->problem, AnalysisChoice::automatic, options);
    INFO(most);
    CHECK(analysis.verdicts.front().state != Verdict::State::holds);
    if (asked <= most) CHECK(analysis.zeno_run.has_value());
  }
}

TEST_CASE("an event that is unanswered at the end of the skill does not count") {
  // The event of MC1 is unanswered for eight rounds of 70 ms, more than is followed exactly; then the skill
  // ends, in every run.
  const Verdict verdict = first_verdict("hand/unanswered_at_end");
  INFO(verdict.explanation.text());
  CHECK(verdict.state == Verdict::State::never);
}

TEST_CASE("a wait for an event that need not come grows for ever") {
  // After motion SM1 waits for a tick, then ends the skill without an answer. The tick may never come.
  const Verdict verdict = first_verdict("hand/need_not_come");
  INFO(verdict.explanation.text());
  CHECK(verdict.state == Verdict::State::fails);
}

TEST_CASE("a value beyond the cap grows for ever when the skill stands still") {
  // SM1 goes round eight times, and then waits for an answer that the device has lost.
  const Verdict verdict = first_verdict("hand/grown_beyond");
  INFO(verdict.explanation.text());
  CHECK(verdict.state == Verdict::State::fails);
}

TEST_CASE("two blocks may answer the events of one clock in the other order") {
  // The long block takes a tick at 0 and is done at 7 ms. The short one takes that of 5 ms and is done at 7
  // ms too, perhaps before. Then the tick of 0 is overtaken. A microsecond later it is not, and all are done
  // in 7 ms.
  CHECK(first_verdict("hand/overtaken").state == Verdict::State::fails);
  CHECK(bound(program("hand/not_overtaken")) == 7);
}

TEST_CASE("an inner block may begin an activity at the instant of its cancellation") {
  // MC1.1 and the first activity of MC1.4 are over at 2 ms. If MC1.4 is earlier it has begun its second one.
  CHECK(bound(program("hand/inner_begins_last")) == 11);
}

TEST_CASE("a chosen message stays the thread's, whatever else is withdrawn before it is taken") {
  // At 2 ms the server answers the second block, which interrupts it till 6 ms; it has chosen the first
  // request. The third is withdrawn at 6 ms, then the first is taken, served and answered.
  CHECK(bound(program("hand/withdrawn_beside")) == 9);
  // The first is withdrawn as well. The server receives it till 8 ms all the same, before the skill
  // completes.
  CHECK(bound(program("hand/both_withdrawn")) == 8);
}

TEST_CASE("no arm of a CASE holds: the skill ends with its first error completion") {
  CHECK(bound(program("hand/first_of_two_errors")) == 2);
}
