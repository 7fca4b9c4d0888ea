#include "server/outbox.hpp"

#include <catch2/catch.hpp>

using pal::server::Outbox;

TEST_CASE("answers and events are kept, the oldest telemetry is dropped and counted") {
  Outbox outbox({100, 2});
  for (const char* sample : {"1", "2", "3"})
    outbox.put_sample(
        {[sample](std::uint64_t dropped) { return sample + std::string("/") + std::to_string(dropped); }});
  CHECK(outbox.put("a"));
  CHECK(outbox.put("b"));
  CHECK(outbox.take()->text == "a");
  CHECK(outbox.take()->text == "b");
  CHECK(outbox.take()->text == "2/1");
  CHECK(outbox.take()->text == "3/1");
  CHECK_FALSE(outbox.take());
}

TEST_CASE("a message that does not fit is refused, never dropped silently") {
  Outbox outbox({10, 2});
  CHECK(outbox.put("0123456789"));
  CHECK_FALSE(outbox.put("x"));
  CHECK(outbox.take());
  CHECK(outbox.put("x"));
}
