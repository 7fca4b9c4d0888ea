// Records on the disk: they come back as they went, and measures are the same from there.
#include "pal/trace/spool.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "pal/trace/measure.hpp"

using namespace pal::trace;

namespace {

/// A condition is set every 5 ms and read 2 ms later, each time a little later.
Trace trace_of(int count) {
  Trace trace;
  trace.skill = "s";
  trace.actors = {{"SM1", false, "P0", 1, -1}};
  trace.statements = {{"SM1", "SPC( c )", "s.pal", 1}, {"SM1", "RPC( c )", "s.pal", 2}};
  trace.conditions = {"c"};
  for (int i = 0; i < count; ++i) {
    const std::int64_t at = 5'000'000LL * i;
    trace.events.push_back({at, Kind::set, 0, 0, 0, 1});
    trace.events.push_back({at + 2'000'000 + i, Kind::read, 0, 1, 0, 1});
    trace.events.push_back({at + 2'000'000 + i, Kind::done, 0, 1, -1, 0});
  }
  return trace;
}

}  // namespace

TEST_CASE("a spool gives back what it was given, from any place on") {
  const Trace trace = trace_of(3000);
  EventSpool spool;
  spool.append(trace.events.data(), 5);
  spool.append(trace.events.data() + 5, trace.events.size() - 5);
  CHECK(spool.size() == trace.events.size());
  for (const std::size_t from : {std::size_t{0}, std::size_t{2048}, std::size_t{8999}, std::size_t{9000}}) {
    Events back;
    spool.for_each([&back](const Event& event) { back.push_back(event); }, from);
    CHECK(back == Events(trace.events.begin() + static_cast<std::ptrdiff_t>(from), trace.events.end()));
  }
  // Reading does not end writing.
  spool.append(trace.events.front());
  CHECK(spool.size() == trace.events.size() + 1);
  CHECK_FALSE(spool.failed());
}

TEST_CASE("a trace on the disk has the same measures and the same file") {
  Trace trace = trace_of(1000);
  EventSpool spool;
  spool.append(trace.events.data(), trace.events.size());
  const std::vector<StatementName> at{{"SM1", "RPC( c )", 2}};
  const auto all = ages(trace, "c", at);
  REQUIRE(all.size() == 1000);
  std::ostringstream in_memory, on_disk;
  write_json(trace, in_memory);
  trace.events.clear();
  CHECK(longest_age(trace, events_of(spool), "c", at) == *longest(all));
  CHECK_FALSE(longest_response(trace, events_of(spool), "SD1", "none", at));
  write_json(trace, events_of(spool), on_disk);
  CHECK(on_disk.str() == in_memory.str());
}
