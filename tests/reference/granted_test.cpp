// What the compositional analysis once took for granted, each with a skill of which it is not so.
#include <catch2/catch.hpp>
#include <string>

#include "tests/reference/bounds_by_hand.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/project_file.hpp"

using pal::test::expect_bounds;

namespace {

/// The text of a skill in tests/reference/granted.
std::string granted(const std::string& name) {
  return pal::test::project_file("tests/reference/granted/" + name + ".pal");
}

/// Whether the compositional analysis says that it has no bound, and a run shows why.
void expect_no_bound(const std::string& text) {
  const auto skill = pal::test::meaningful_skill(text);
  const auto compositional = pal::analyzer::compositional::analyze(*skill->problem);
  CHECK_FALSE(compositional.verdicts.front().bound);
  const auto exact = pal::analyzer::analyze_exactly(*skill->problem);
  CHECK(exact.verdicts.front().state != pal::analyzer::VerdictState::holds);
}

/// The same, where the greatest value in milliseconds is known.
void expect_age(const std::string& text, int exact_value) {
  const auto skill = pal::test::meaningful_skill(text);
  CHECK_FALSE(pal::analyzer::compositional::analyze(*skill->problem).verdicts.front().bound);
  CHECK(pal::test::milliseconds(pal::analyzer::analyze_exactly(*skill->problem).verdicts.front()) ==
        exact_value);
}

}  // namespace

TEST_CASE("what follows a block waits for the work that the block has delayed") {
  // The controller obeys from 0; the block has the processor from 0.5 to 25.5. Then there are 8.5 ms of the
  // first tick left, and two more ticks have come.
  expect_bounds(granted("preempted"), {{87.5, 53.5}});
}

TEST_CASE("a send that waits for its slot makes what was read before it older") {
  // The first motion is taken only after the 45 ms that MC3 works; the next one is put 30 ms after it.
  expect_bounds(granted("held"), {{15, 15}});
}

TEST_CASE("a thread that never blocks keeps a nonpreemptive processor") {
  // The answer comes after 1 ms of the 5 that LS1 thinks.
  expect_bounds(granted("hogging"), {{-1, -1}});
}

TEST_CASE(
    "a thread that was held in a send finds its answer there and keeps the processor for one round more") {
  // SD1 is freed and tidies for 3 ms, takes what it asked for before, thinks for 5, finds the slot free, and
  // tidies for 3 more.
  expect_bounds(granted("freed"), {{17, 12}});
}

TEST_CASE("an answer that another block waits for begins work") {
  // SM1.1 asks, SM1.2 takes the answer and works for 10 ms.
  expect_bounds(granted("passed_on"), {{-1, 10}});
}

TEST_CASE("an answer may be taken by a block that has not asked for it") {
  // Once in its life SM1.2 takes what SM1.1 asked for, and works for 10 ms more; MC1 obeys after that.
  expect_bounds(granted("taken_away"), {{-1, 21}});
}

TEST_CASE("a limit starts again if the message that a thread is about to take is withdrawn") {
  // SM1.1 gives up at 6 what SM1.2 is taking until 6.3. From then SM1.2 waits 5.5 again, and gives up in 1.
  expect_bounds(granted("withdrawn"), {{-1, 12.8}});
}

TEST_CASE("an answer that a round leaves is taken by the next") {
  // What SM1 asks for in one round it takes in the next, 20 ms later.
  expect_bounds(granted("left"), {{-1, 20.5}, {-1, 1.5}});
}

TEST_CASE("a message that a job waits for may come twice") {
  // SM1 asks at 2 and, since MC1 moves till 6 and its answer is under way till 8, once more at 7. MC1 takes
  // that in the round of 11.5, before the gauge was asked again.
  expect_bounds(granted("asked_twice_for"), {{-1, 11.5}});
}

TEST_CASE("a value that is read before it is set again is as old as the loop") {
  // SM1 is at home in its second loop; the first one goes round with the beat.
  expect_bounds(granted("set_round_a_loop"), {{-1, 10}});
}

TEST_CASE("frames that no thread asks for any more are lost") {
  // LS1 asks once, at the start.
  expect_no_bound(granted("asked_once"));
}

TEST_CASE("a block that does not begin reacts to nothing") {
  // SM1 waits for what LS1 need not send; the first set, and the first sample, are then never reflected.
  expect_no_bound(granted("never_begun"));
  expect_no_bound(granted("never_taken"));
}

TEST_CASE("what a thread began before its rounds may come after it has come home") {
  // MC1 takes what it asked for at its start in its first round.
  expect_age(granted("later_rounds"), 71);
}

TEST_CASE("a reaction goes on where another thread comes to its statement") {
  // LS1 has worked at its start, and its block works on; neither has read what was set.
  expect_no_bound(granted("elsewhere"));
}

TEST_CASE("more than a period after its event: meets a longer later event") {
  // SM1 thinks at 15 after an event. If the next comes no sooner SD1 looks then, too, and SD2 reacts after
  // both.
  expect_bounds(granted("drifting"), {{4, 4}});
}

TEST_CASE("more than a period after its event: delayed by a longer later event") {
  // SM1 is to think from 17 to 19. The next event comes at 17, and SD1 looks for 3 ms.
  expect_bounds(granted("drifting_itself"), {{22, 22}});
}

TEST_CASE("a job is as short as its block needs") {
  // If c holds SD1 asks at once, in a block, and has the next value after 1 ms; else after more than 50.
  expect_bounds(granted("asked_in_a_block"), {{-1, 21}});
}

TEST_CASE("a thread that may end before it has come home takes nothing") {
  // If c does not hold LS1 ends at once, and no thread takes what SD2 sends.
  expect_no_bound(granted("ended"));
}

TEST_CASE("a module may answer a request that it took in another place") {
  // The second answer comes as well, and the 50 ms that SM1 thinks then keep MC1 waiting.
  expect_bounds(granted("answered_elsewhere"), {{51, 51}});
}

TEST_CASE("a block may ask for what its parent waits for") {
  // SM1 has the processor for 4 ms in 9.
  expect_bounds(granted("block_asks"), {{-1, 76}});
}

TEST_CASE("two events may come while a skill ends") {
  // MC1 has the processor until 40, SM1.1 until 70. The tick of 50 ms is still there when that of 100 comes.
  expect_no_bound(granted("while_ending"));
}

TEST_CASE("what stands after blocks that never end takes nothing") {
  // LS1.1 goes round for ever, so LS1 never comes to its wait for x, nor to the blocks that wait for it.
  expect_no_bound(granted("never_past"));
  expect_no_bound(granted("never_past_to_blocks"));
}

TEST_CASE("a round that may send to one slot three times finds it full") {
  // MC2 obeys the first motion until 6, the one of 3 is in the slot till then, and the one of 4 waits for it.
  expect_bounds(granted("sent_thrice"), {{-1, 7}});
  // That MC1 may have to wait comes from there.
  const auto skill = pal::test::meaningful_skill(granted("sent_thrice"));
  const auto analysis = pal::analyzer::compositional::analyze(*skill->problem);
  const std::string why = analysis.verdicts.front().explanation.text();
  INFO(why);
  CHECK(why.find("since SM1 may find the slot full at TXM( motion to MC2 )") != std::string::npos);
}

TEST_CASE("what comes by one of two ways piles up on both") {
  // When the arm is there, SM1 finds the tick of the clock, and the one that SD1 cannot send. On each of the
  // two ways there are three more. One is in the slot before the sensor, the sensor cannot hand on the
  // second, and the third is in the slot after it. If the arm is quick now, these and the next tick keep SD2
  // for 9 times 0.5 ms.
  expect_bounds(granted("piled_up"), {{5.1, 4.6}, {5.1, 4.6}});
}
