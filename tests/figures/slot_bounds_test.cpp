// Bounds where sends wait for their slots, by numbers that can be reckoned by hand.
#include <catch2/catch.hpp>
#include <string>

#include "tests/figures/bounds_by_hand.hpp"
#include "tests/support/project_file.hpp"

using pal::test::compare;

namespace {

/// The text of a skill in tests/figures/slots.
std::string slots(const std::string& name) {
  return pal::test::project_file("tests/figures/slots/" + name + ".pal");
}

}  // namespace

TEST_CASE("a wait for a slot holds up the round that follows") {
  // A method asks for a force every 5 ms and sends motions, which a controller obeys at once, but for 20 ms
  // every 100 in which a driver has its processor.
  // The controller begins to obey 20 late and takes the motion then. The method is held with the next one, 5
  // later, and is home 15 after that round began.
  compare(slots("held_in_its_last_send"), {{15, 15}, {30, 20}, {35, 25}, {36, 26}});
}

TEST_CASE("who waits for a slot does not keep its taker waiting") {
  // A clock of 10 ms with jitter, a courier without work, and a module that is kept from its processor for 14
  // ms every 50: the courier's next send finds the slot full.
  // An event comes 2 late and its message is taken 14 later. The next event is punctual, and its message held
  // for 6. No message is done later than 14 and 1 after its event.
  compare(slots("full_slot"), {{6, 6}, {15, 15}});
}

TEST_CASE("sends of one round of which each run comes to one are taken before the next round's") {
  // 3 or 5 to ask, 1 to think, 2 to obey.
  compare(slots("sent_after_branches"), {{6, 6}, {8, 8}, {22, 22}, {18, 18}, {2, 2}});
  // The answer is there after 2 to 5, or given up at 5 and guessed by 6. The bounds count as if it could be
  // there at once.
  compare(slots("sent_after_a_limit"), {{6, 6}, {8, 8}, {26, 24}, {14, 16}, {7, 2}});
}

TEST_CASE("a server that a round asks twice is asked one time after the other") {
  // 5 to be answered, twice; 1 to think, 2 to obey.
  compare(slots("asked_twice"), {{11, 11}, {13, 13}, {20, 20}, {20, 20}, {2, 2}});
}
