// Bounds where sends wait for their slots, by figures that can be worked out by hand.
#include <catch2/catch.hpp>
#include <string>

#include "tests/reference/bounds_by_hand.hpp"
#include "tests/support/project_file.hpp"

using pal::test::expect_bounds;

namespace {

/// The text of a skill in tests/reference/slots.
std::string slots(const std::string& name) {
  return pal::test::project_file("tests/reference/slots/" + name + ".pal");
}

}  // namespace

TEST_CASE("a wait for a slot holds up the round that follows") {
  // A method asks for a force every 5 ms and sends motions. A controller obeys them at once, except for 20 ms
  // in every 100 ms, in which a driver has its processor. The controller begins to obey 20 late and takes the
  // motion then. The method is held with the next one, 5 later, and is home 15 after that round began.
  expect_bounds(slots("held_in_its_last_send"), {{15, 15}, {30, 20}, {35, 25}, {36, 26}});
}

TEST_CASE("a sender that waits for a slot does not delay its receiver") {
  // A clock of 10 ms with jitter, a courier without work, and a module. The module is kept from its processor
  // for 14 ms in every 50 ms. Then the courier's next send finds the slot full. An event comes 2 late and its
  // message is taken 14 later. The next event is punctual, and its message held for 6. No message is done
  // later than 14 and 1 after its event.
  expect_bounds(slots("full_slot"), {{6, 6}, {15, 15}});
}

TEST_CASE("exclusive sends of one job are taken before those of the next job") {
  // 3 or 5 to ask, 1 to think, 2 to obey.
  expect_bounds(slots("sent_after_branches"), {{6, 6}, {8, 8}, {22, 22}, {18, 18}, {2, 2}});
  // The answer is there after 2 to 5, or given up at 5 and guessed by 6. The bounds count as if it could be
  // there at once.
  expect_bounds(slots("sent_after_a_limit"), {{6, 6}, {8, 8}, {26, 24}, {14, 16}, {7, 2}});
}

namespace {

/// The skill of sent_after_branches, that asks by branches so many times in a round.
std::string branches_in_a_row(int times) {
  const std::string text = slots("sent_after_branches");
  const std::size_t begin = text.find("    CASE\n");
  const std::size_t end = text.find("    think\n");
  std::string made = text.substr(0, begin);
  for (int i = 0; i < times; ++i) made += text.substr(begin, end - begin);
  return made + text.substr(end);
}

}  // namespace

TEST_CASE("branches in a row count with the longest way through each") {
  // Twice 3 or 5 to ask, 1 to think, 2 to obey.
  expect_bounds(branches_in_a_row(2), {{11, 11}, {13, 13}, {24, 24}, {16, 16}, {2, 2}});
}

TEST_CASE("branches that multiply without end have no bound, which is found soon") {
  const auto skill = pal::test::sound_skill(branches_in_a_row(12));
  const auto analysis = pal::analyzer::compositional::analyze(*skill->problem);
  CHECK_FALSE(analysis.verdicts.front().bound);
}

TEST_CASE("a server that a round asks twice is asked one time after the other") {
  // 5 to be answered, twice; 1 to think, 2 to obey.
  expect_bounds(slots("asked_twice"), {{11, 11}, {13, 13}, {20, 20}, {20, 20}, {2, 2}});
}
