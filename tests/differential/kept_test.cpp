// Samples that go from block to block with the messages that a module keeps.
#include <catch2/catch.hpp>

#include "tests/differential/agreed.hpp"

using pal::test::agreed_bounds;
using pal::test::Bounds;
using pal::test::sliced_bounds;

TEST_CASE("an activity has the sample of its message, whichever block took the message") {
  // A force takes 4 ms, and the next comes just after 2 ms of regulating have begun.
  CHECK(agreed_bounds("kept/across_blocks") ==
        Bounds{{"used", 10}, {"sent", 10}, {"set", 10}, {"in-loop", 10}, {"noticed", 18}, {"answered", 2}});
}

TEST_CASE("a message that an activity writes carries the sample that its thread knew") {
  // A profile takes up to 5 ms, a send 1 ms, and interpreting 2 ms; a send of the other block may lie
  // between.
  CHECK(agreed_bounds("kept/written_in_a_block") ==
        Bounds{{"sent", 14}, {"written", 8}, {"after", 17}, {"noticed", 28}});
}

TEST_CASE("a driver reads its device in one block and serves its client in another") {
  // A reading takes 5 ms, and is up to 10 ms old when it is sent; then 1 ms of scaling, and 3 ms of the act.
  CHECK(agreed_bounds("kept/server") == Bounds{{"fresh", 11}, {"used", 14}, {"noticed", 18}});
}

TEST_CASE("a slice keeps all threads that send a message with a sample") {
  for (const std::string name : {"kept/across_blocks", "kept/written_in_a_block", "kept/server"}) {
    INFO(name);
    CHECK(sliced_bounds(name) == pal::test::explored_bounds(name));
  }
}
