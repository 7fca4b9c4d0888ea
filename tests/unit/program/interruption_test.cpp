// Ctrl-C while a command works: once it only sets a mark.
#include "programs/pal/session/interruption.hpp"

#include <catch2/catch.hpp>
#include <csignal>

using pal::program::Interruption;

TEST_CASE("Ctrl-C after a proof and before its report is written is only marked") {
  const Interruption command;
  { const Interruption proof; }
  std::raise(SIGINT);
  CHECK(Interruption::asked_for());
  const Interruption another;  // forgets nothing
  CHECK(Interruption::asked_for());
}

TEST_CASE("an interruption affects one command only") {
  const Interruption command;
  CHECK_FALSE(Interruption::asked_for());
}
