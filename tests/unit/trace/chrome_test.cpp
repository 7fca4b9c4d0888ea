// The export for trace viewers, read back by an independent JSON reader.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "pal/trace/trace.hpp"

namespace pal::trace {
namespace {

using Json = nlohmann::json;

Json exported(const Trace& trace) {
  std::ostringstream out;
  write_chrome(trace, out);
  return Json::parse(out.str());
}

std::vector<Json> with(const Json& root, const char* key, const Json& value) {
  std::vector<Json> found;
  for (const Json& event : root["traceEvents"]) {
    if (event.contains(key) && event[key] == value) found.push_back(event);
  }
  return found;
}

Trace one_message() {
  Trace trace;
  trace.skill = "touch";
  trace.actors = {{"SM1", false, "P0", 1}, {"LS1", false, "P1", 1}, {"alter", true, "", 0}};
  trace.statements = {{"SM1", "TXM( request Zforce from LS1 )", "touch.pal", 34},
                      {"LS1", "WTM( request Zforce from SM1 )", "modules.pal", 12}};
  trace.channels = {{"SM1", "request Zforce", "LS1"}, {"alter", "tick", "MC1"}};
  trace.conditions = {"pc-force"};
  trace.events = {
      {0, Kind::block, 1, 1, 0, 0},       {0, Kind::start, 0, 0, -1, 0},
      {50000, Kind::put, 0, 0, 0, 7},     {50000, Kind::done, 0, 0, -1, 0},
      {50123, Kind::start, 1, 1, -1, 0},  {100000, Kind::take, 1, 1, 0, 7},
      {100000, Kind::done, 1, 1, -1, 0},  {28000001, Kind::put, 2, -1, 1, 1},
      {28000002, Kind::set, 0, -1, 0, 1}, {28000003, Kind::complete, 0, -1, -1, 0},
  };
  return trace;
}

TEST_CASE("each processor is a process with its threads, the devices are one more") {
  const Json root = exported(one_message());
  std::vector<std::string> processes;
  for (const Json& event : with(root, "name", "process_name")) processes.push_back(event["args"]["name"]);
  CHECK(processes == std::vector<std::string>{"skill touch", "processor P0", "processor P1", "devices"});
  const auto threads = with(root, "name", "thread_name");
  REQUIRE(threads.size() == 3);
  CHECK(threads[0]["pid"] != threads[1]["pid"]);
  CHECK(threads[2]["args"]["name"] == "alter");
}

TEST_CASE("a message is a flow from the send to the receive") {
  const Json root = exported(one_message());
  const auto sends = with(root, "name", "TXM( request Zforce from LS1 )");
  const auto receives = with(root, "name", "WTM( request Zforce from SM1 )");
  REQUIRE(sends.size() == 1);
  REQUIRE(receives.size() == 1);
  CHECK(sends[0]["flow_out"] == true);
  CHECK(receives[0]["flow_in"] == true);
  CHECK(sends[0]["bind_id"] == receives[0]["bind_id"]);
  CHECK(with(root, "name", "tick")[0]["bind_id"] != sends[0]["bind_id"]);
  CHECK(sends[0]["args"]["line"] == "touch.pal:34");
}

TEST_CASE("times are microseconds to the nanosecond") {
  std::ostringstream out;
  write_chrome(one_message(), out);
  CHECK_THAT(out.str(), Catch::Contains("\"ts\":50.123,\"dur\":49.877"));
  CHECK_THAT(out.str(), Catch::Contains("\"ts\":28000.001,\"dur\":0.000"));
}

TEST_CASE("conditions are counters that start FALSE") {
  const auto counters = with(exported(one_message()), "ph", "C");
  REQUIRE(counters.size() == 2);
  CHECK(counters[0]["args"]["value"] == 0);
  CHECK(counters[1]["args"]["value"] == 1);
  CHECK(counters[1]["name"] == "pc-force");
}

TEST_CASE("a wait before a receive is a slice, and the end of the skill an instant") {
  const Json root = exported(one_message());
  CHECK(with(root, "cat", "wait").size() == 1);
  CHECK(with(root, "name", "completion 0").size() == 1);
}

}  // namespace
}  // namespace pal::trace
