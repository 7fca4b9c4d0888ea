// What happens at one instant happens in any order that causes allow: programs that depend on an order.
#include "tests/differential/by_hand.hpp"

using pal::test::bound;
using pal::test::program;

TEST_CASE("one instant: a device takes its next request, and its answer is put") {
  // At 10 ms the answer a wakes MC1, and the request that is taken then lets MC2 go on, which was blocked in
  // its second one. They share a queue: MC1 may have to wait for the 5 ms of MC2.
  CHECK(bound(program("one_instant/idle_device")) == 16);
}

TEST_CASE("a wait that gives up goes on between two senders that it has freed") {
  // At 15 ms SM1 withdraws what it asked of MC1 and of MC2, of which each is blocked in a second answer. The
  // block that begins then may come to the queue between them, and find that one has set its condition and
  // the other has not.
  CHECK(bound(program("one_instant/gives_up_between")) == 65);
}

TEST_CASE("one instant: the parent goes on, and cancelled blocks have freed other threads") {
  // At 15 ms both other blocks are cancelled. The first has asked MC1 for X. Its cancellation frees MC1. SM1
  // may still come to the queue before MC1, and test before MC1 sets.
  CHECK(bound(program("one_instant/parent_before_freed")) == 65);
}

TEST_CASE("a pause of no length need not end a busy period") {
  // P is idle while SM1 waits for the answer of MC1, which comes at the same instant.
  CHECK(bound(program("one_instant/pause_of_no_length")) == 10);
}

TEST_CASE("a skill that ends during a pause of no length ends like any other") {
  // MC1 has P for 2 ms. At that instant SM1 completes, before the pause of P is over or after it.
  CHECK(bound(program("one_instant/ends_in_pause")) == 2);
}

TEST_CASE("one instant: a cancelled thread stops, and another thread is freed") {
  // At 15 ms SM1.2 gives up. That lets SM1.1 put its second request and end, which cancels SM1.2; and it
  // frees MC2, which is blocked in a second answer. SM1 may go on before MC2 comes to the queue and sets its
  // condition.
  CHECK(bound(program("one_instant/stops_or_is_freed")) == 65);
}

TEST_CASE("one instant: a stopped block's message is withdrawn, another thread ends its wait") {
  // At 3 ms the inner loop is cancelled, for which X was there and which has not had the processor yet. What
  // it asked for is withdrawn. Either SM1.1 never knows of X, and gives up at 6 ms, before c is set. Or it
  // stops waiting for X, finds it withdrawn, and waits 5 ms more.
  CHECK(bound(program("one_instant/withdrawn_or_left")) == 56);
}

TEST_CASE("two stopped blocks: one has requested the message that the other was to take") {
  // As before; but the block that X was there for, SM1.3, is not the one that has asked for it, SM1.4.
  CHECK(bound(program("one_instant/asked_by_another")) == 56);
}

TEST_CASE("two threads at one statement and instant each have their own past") {
  // At 15 ms MC1 takes the first X. That lets SM1.1 send, whose X is discarded, with the value of c from the
  // start; and SM1.2 with that of 11 ms.
  CHECK(bound(program("one_instant/same_statement")) == 15);
}

TEST_CASE("blocks behind blocks of no length join the queue with the modules at the start") {
  // MC1 goes on to its second CONCURRENT at once. Its block may come to the queue of SM1 before SM1.
  CHECK(bound(program("one_instant/over_at_once")) == 12);
}

TEST_CASE("a message with a latency of 0 is there before anything else happens") {
  // At 1 ms go is there for SM1.1, to which it took no time, as well as for SM1.2.
  CHECK(bound(program("one_instant/no_way")) == 11);
  // At 1 ms go brings SM1.1 to the queue of Q before MC1.1 begins there.
  CHECK(bound(program("one_instant/no_way_to_a_queue")) == 13);
}
