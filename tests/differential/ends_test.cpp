// Skills whose last round is unlike those before. It works or waits for longer, and leaves out what comes in
// all others.
#include <catch2/catch.hpp>

#include "tests/differential/by_hand.hpp"
#include "tests/differential/not_below.hpp"

using pal::test::exact_and_not_below;

namespace {

/// In nanoseconds, or a number of frames.
std::int64_t bound_of(const std::string& name) {
  INFO(name);
  return exact_and_not_below(pal::test::program("ends/" + name));
}

constexpr std::int64_t ms = 1'000'000;

}  // namespace

TEST_CASE("a condition keeps its value while the last round goes on") {
  // After the last set SM1 works for 200 ms more; or asks for 500 ms, 100 ms after it.
  CHECK(bound_of("slowly") == 200 * ms + ms / 2);
  CHECK(bound_of("asks_last") == 600 * ms);
  // The last event brings no set, but 80 ms in which SM1 waits, or 15 ms in which it does not ask LS1.
  CHECK(bound_of("by_event") == 180 * ms);
  CHECK(bound_of("instead") == 35 * ms);
  // The reader is SM1 itself, in what comes after its rounds.
  CHECK(bound_of("own_tail") == 180 * ms + ms / 2);
  CHECK(bound_of("blocks_last") == 180 * ms + ms / 2);
}

TEST_CASE("a condition that is never set keeps its value until the skill ends") {
  CHECK(bound_of("at_start") == 200 * ms);
  CHECK(bound_of("unset") == 18 * ms);
  CHECK(bound_of("unset_by_other") == 90 * ms);
}

TEST_CASE("what other threads reach while the last job goes on counts") {
  // SM1 does not come to the statement any more, but MC1 does when the skill ends.
  CHECK(bound_of("others_pass") == 600 * ms);
  CHECK(bound_of("others_react") == 180 * ms);
  // MC1 learns by another condition what is newer.
  CHECK(bound_of("newer_at_end") == 187 * ms + ms / 2);
}

TEST_CASE("the next effect may come in a job that never ends") {
  // SM1 asks once more, uses what it knows then, and leaves, or completes; or it does so before its rounds.
  CHECK(bound_of("leaver_reacts") == 22 * ms);
  CHECK(bound_of("reacts_last") == 22 * ms);
  CHECK(bound_of("reacts_at_start") == 132 * ms);
}

TEST_CASE("what devices send while the last job goes on is lost") {
  // MC1 waits 200 ms for one more answer, which does not come, while five ticks find another in the slot.
  CHECK(bound_of("answers") == 5);
  // SM1 works for 90 ms and does not come home at all: of four ticks two find another in the slot.
  CHECK(bound_of("never_home") == 2);
  // SM1 asks for no frame any more for 190 ms.
  CHECK(bound_of("frames") == 16);
}
