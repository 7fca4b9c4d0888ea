// What is not always there, or may be somewhere else: blocks with rounds of their own, takers of a message.
#include <string>

#include "analyzer/analysis.hpp"
#include "tests/reference/bounds_by_hand.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/project_file.hpp"

using pal::test::expect_bounds;

namespace {

/// Whether the compositional analysis has no bound for any requirement, and a run breaks the first.
void expect_refuted(const std::string& name) {
  const auto skill =
      pal::test::any_skill(pal::test::project_file("tests/reference/granted/" + name + ".pal"));
  REQUIRE(skill->problem);
  const auto compositional = pal::analyzer::compositional::analyze(*skill->problem);
  for (const auto& verdict : compositional.verdicts) CHECK_FALSE(verdict.bound);
  pal::analyzer::Options brief;
  brief.max_states = 300;
  const auto found = pal::analyzer::analyze(*skill->problem, pal::analyzer::AnalysisChoice::exact, brief);
  CHECK(found.verdicts.front().state == pal::analyzer::VerdictState::fails);
}

}  // namespace

TEST_CASE("a message to a block that is started again waits for the block") {
  // LS1 has read what is 10 ms old, and waits 70 ms for the block to be there again. In each 100 ms the block
  // finds two messages more than come in its 5 ms.
  expect_bounds(pal::test::project_file("tests/reference/granted/nested_blocks.pal"), {{-1, 81}, {-1, 10}});
}

TEST_CASE("what is sent to a block that a message starts waits for that message") {
  // It may come 70 ms after LS1 has come to its second send.
  expect_bounds(pal::test::project_file("tests/reference/granted/nested_once.pal"), {{-1, 81}, {-1, 10}});
}

TEST_CASE("an event that waits for a restarted block may be taken just before the next event") {
  expect_bounds(pal::test::project_file("tests/reference/granted/nested_event.pal"), {{-1, 1}, {-1, 3}});
}

TEST_CASE("a block that is cancelled in each round may never reach its statement") {
  expect_refuted("nested_stopped");
}

TEST_CASE("a message that a block only looks for stays when the block is gone") {
  // LS1 sends every 30 ms, and SM1 looks every 100 ms.
  expect_refuted("taker_gone");
}

TEST_CASE("an event that is taken at the start is not answered by a later wait") {
  expect_refuted("looked_for");
}

TEST_CASE("a wait WITHIN may serve a request after the block that served it is gone") {
  expect_refuted("served_late");
}

TEST_CASE("an event is lost with an answer that no thread waits for any more") {
  expect_refuted("discarded");
}

TEST_CASE("a limit starts again after a message that comes once") {
  // MC1 holds at 30, is told to go at 60, and holds again at 91.
  expect_bounds(pal::test::project_file("tests/reference/granted/commanded.pal"), {{65, 61}});
}

TEST_CASE("which of two waiting blocks takes a message is open") {
  expect_refuted("taken_by_two");
}

TEST_CASE("nothing is known of a limit for a request") {
  expect_refuted("limit_for_a_request");
}

TEST_CASE("nothing is known of what a block within a block sends") {
  expect_refuted("sent_from_within");
}

TEST_CASE("a message sent at the start of a thread may be taken in any round") {
  // Each is told to stop while it waits for something else, in a round or between two limits.
  expect_refuted("told_later");
  expect_refuted("told_between_limits");
  expect_refuted("told_in_a_branch");
}

TEST_CASE("a device that asks by itself asks again before it has its answer") {
  expect_refuted("asked_by_a_device");
}

TEST_CASE("a device's request between two blocks that answer waits for the second") {
  // A request of 15 ms or more waits for the second block, and the next one comes with it.
  expect_refuted("asked_in_between");
}
