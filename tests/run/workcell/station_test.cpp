// Skills in the cell: over every kind of link, one after the other, and with lines that go wrong.
#include <algorithm>
#include <catch2/catch.hpp>

#include "programs/workcell/session/session.hpp"
#include "runtime/drivers/streams/carrier.hpp"
#include "sim/cell/cell.hpp"
#include "tests/support/built_skills.hpp"

using namespace pal;
using namespace pal::workcell;
using namespace std::chrono_literals;

namespace {

Session station_session() {
  Session session;
  session.scene = sim::find_scene("touch", {PAL_SCENE_DIR});
  session.seed = 5;
  return session;
}

SessionResult run(const Session& session) {
  return run_session(*test::make_skill("touch"), session);
}

}  // namespace

TEST_CASE("a run is the same whatever carries the bytes") {
  Session one = station_session();
  const SessionResult in_process = run(one);
  CHECK(in_process.outcome.code == 0);
  for (auto* const carrier : {&runtime::drivers::pseudo_terminal_carrier, &runtime::drivers::tcp_carrier}) {
    one.carrier = carrier;
    const SessionResult outside = run(one);
    CHECK(outside.outcome.trace.events == in_process.outcome.trace.events);
    CHECK(outside.peak_force == in_process.peak_force);
    REQUIRE(outside.log.size() == in_process.log.size());
    CHECK(outside.log.back().tool == in_process.log.back().tool);
  }
}

// A phase of a whole period is one of 0: a tick comes at the beginning.
TEST_CASE("the phase is from the skill's beginning to the first tick") {
  for (const runtime::Time phase : {runtime::Time(0ms), runtime::Time(7ms), runtime::Time(27999us)}) {
    Session one = station_session();
    one.phase = phase;
    const SessionResult result = run(one);
    const trace::Trace& trace = result.outcome.trace;
    const auto tick = std::find_if(trace.events.begin(), trace.events.end(), [&](const trace::Event& event) {
      return event.kind == trace::Kind::put &&
             trace.channels[static_cast<std::size_t>(event.subject)].message == "tick";
    });
    REQUIRE(tick != trace.events.end());
    CHECK(tick->time_ns == phase.count());
  }
}

TEST_CASE("skills run one after the other, and ALTER is answered between them") {
  sim::Cell cell(station_session().scene);
  const auto skill = test::make_skill("touch");
  CHECK(cell.run(*skill).code == 0);
  const runtime::Time first = cell.station().begun();
  cell.rest(1s);
  const double there = cell.workcell().tool().translation().z();
  cell.rest(2s);
  CHECK(cell.workcell().tool().translation().z() == Approx(there).margin(1e-5));  // answered with no motion
  // The tool touches: the second run ends at once, and hardly moves.
  const runtime::Outcome second = cell.run(*skill);
  CHECK(second.code == 0);
  CHECK_FALSE(second.fault);
  CHECK(cell.station().begun() > first + 2s);
  CHECK(cell.workcell().tool().translation().z() == Approx(there).margin(2e-3));
}

TEST_CASE("a device whose line is cut refuses the next skill, and is used when it is back") {
  sim::CellOptions options;
  options.seed = 5;
  options.faults = std::get<0>(sim::read_faults("at 500 ms force-torque unplug"));
  sim::Cell cell(station_session().scene, options);
  const auto skill = test::make_skill("touch");
  CHECK(cell.run(*skill).reason == "force-torque: the link is broken: unplugged");
  cell.rest(2s);
  const runtime::Outcome refused = cell.run(*skill);
  CHECK(refused.fault);
  CHECK(refused.duration == 0s);
  CHECK(refused.reason.find("force-torque: ") == 0);
  for (const auto& line : cell.lines()) {
    if (line.device == "force-torque") line.wire->mend();
  }
  cell.rest(2s);
  const runtime::Outcome back = cell.run(*skill);
  CHECK(back.code == 0);
  CHECK_FALSE(back.fault);
}

TEST_CASE("each fault of a line ends the skill with a reason and the arm at rest") {
  struct Case {
    const char* fault;
    const char* reason;
  };
  for (const Case& each :
       {Case{"at 500 ms force-torque dropout",
             "force-torque: no record came within 20 ms; is it switched on, and is its cable plugged in?"},
        Case{"at 500 ms force-torque garble",
             "force-torque: a record begins with the byte 04, which is no overload byte"},
        Case{"at 0.5 s force-torque unplug", "force-torque: the link is broken: unplugged"},
        Case{"at 500 ms alter late-answer 25 ms",
             "alter: got no correction within 24 ms of the beginning of its cycle"},
        Case{"at 500 ms alter garble", "alter: the line is disturbed: a frame's checksum is wrong"},
        Case{"at 500 ms alter unplug", "alter: the link is broken: unplugged"}}) {
    CAPTURE(each.fault);
    Session one = station_session();
    one.faults = std::get<0>(sim::read_faults(each.fault));
    const SessionResult result = run(one);
    CHECK(result.outcome.fault);
    CHECK(result.outcome.code == 2);  // the template's error completion
    CHECK(result.outcome.reason == each.reason);
    REQUIRE(result.log.size() > 100);
    const auto& last = result.log.back();
    const auto& before = result.log[result.log.size() - 100];
    CHECK((last.tool - before.tool).norm() < 1e-5);
  }
}

TEST_CASE("a run breaks no promise, with a late line it does, and the policy is followed") {
  using runtime::OnBrokenPromise;
  Session one = station_session();
  one.on_broken_promise = OnBrokenPromise::stop;
  const SessionResult kept = run(one);
  CHECK(kept.outcome.code == 0);
  CHECK(kept.outcome.broken_promises.empty());

  one.faults = std::get<0>(sim::read_faults("at 500 ms force-torque late 3 ms"));
  const SessionResult stopped = run(one);
  CHECK(stopped.outcome.fault);
  CHECK(stopped.outcome.code == 2);
  CHECK(stopped.outcome.reason.find(
            "force-torque answers 6 ms after a request at the latest: measured 6.000001 ms; "
            "endangers answer-alter, fresh-force") == 0);

  one.on_broken_promise = OnBrokenPromise::report;
  const SessionResult noted = run(one);
  CHECK(noted.outcome.code == 0);
  CHECK_FALSE(noted.outcome.fault);
  REQUIRE_FALSE(noted.outcome.broken_promises.empty());
  CHECK(noted.outcome.broken_promises.front().times > 5);
  CHECK(noted.outcome.broken_promises.front().by == "force-torque");
}

TEST_CASE("each fault of the arm ends the skill with the template's code and the arm at rest") {
  struct Case {
    const char* skill;
    const char* scene;
    std::vector<runtime::ParameterValue> parameters;
    int code;
    bool fault;
    const char* said;  // by ALTER as the reason, by VAL as the controller's words
  };
  for (const Case& each :
       {Case{"touch",
             "bar-under-forearm",
             {{"approach-speed", 60}},
             2,
             true,
             "alter: the forearm hit the bar"},
        Case{"align",
             "near-limit",
             {},
             2,
             true,
             "alter: cannot make the motion: joint 4 would leave its range of -110 to 170 degrees"},
        Case{"relative-move", "near-limit", {{"ry", 10}}, 1, false, "Joint out of range Jt 4"},
        Case{"touch",
             "edge-of-reach",
             {{"reach", 300}, {"approach-speed", 60}},
             2,
             true,
             "alter: cannot make the motion: the tool would be out of the arm's reach"},
        Case{"relative-move", "edge-of-reach", {{"dz", 300}}, 1, false, "Location too far"},
        Case{"align",
             "near-singularity",
             {},
             2,
             true,
             "alter: cannot make the motion: joint 4 would turn at "},
        Case{"relative-move", "near-singularity", {{"rx", 10}}, 1, false, "Joint too fast Jt 4"}}) {
    CAPTURE(each.skill, each.scene);
    Session one = station_session();
    one.scene = sim::find_scene(each.scene, {PAL_SCENE_DIR});
    one.parameters = each.parameters;
    const SessionResult result = run_session(*test::make_skill(each.skill), one);
    CHECK(result.outcome.code == each.code);
    CHECK(result.outcome.fault == each.fault);
    CHECK((each.fault ? result.outcome.reason : result.controller).find(each.said) == 0);
    REQUIRE(result.log.size() > 100);
    const auto& last = result.log.back();
    const auto& before = result.log[result.log.size() - 100];
    CHECK((last.tool - before.tool).norm() < 1e-4);
  }
}

TEST_CASE("a file of faults can make a statement slow") {
  const auto read = std::get<0>(sim::read_faults("at 2 s SM1:55 takes 40 ms"));
  REQUIRE(read.size() == 1);
  CHECK(read[0].kind == sim::PlannedFault::Kind::takes);
  CHECK(read[0].device == "SM1");
  CHECK(read[0].statement == 55);
  CHECK(read[0].by == 40ms);
  for (const char* wrong : {"at 2 s SM1 takes 40 ms", "at 2 s SM1: takes 40 ms", "at 2 s SM1:0 takes 40 ms"})
    CHECK(std::get<sim::FaultTextError>(sim::read_faults(wrong)).cause.find("a statement is named by") == 0);
}

TEST_CASE("faults are read line by line, and errors name the line") {
  const auto good = sim::read_faults("# nothing\n\nat 1.5 s alter late 4 ms # why not\n");
  REQUIRE(good.index() == 0);
  REQUIRE(std::get<0>(good).size() == 1);
  CHECK(std::get<0>(good)[0].at == 1500ms);
  CHECK(std::get<0>(good)[0].by == 4ms);
  for (const auto& [text, cause] : std::vector<std::pair<const char*, const char*>>{
           {"\nat 5 m alter unplug", "a time has the unit ms or s, not 'm'"},
           {"\nat x ms alter unplug", "'x' is not a number"},
           {"\nat 5 ms alter unplug now", "'now' is more than a fault has"},
           {"\nat -5 ms alter unplug", "a time is from 0 to 3600 s"}}) {
    const auto wrong = sim::read_faults(text);
    REQUIRE(wrong.index() == 1);
    CHECK(std::get<1>(wrong).line == 2);
    CHECK(std::get<1>(wrong).cause == cause);
  }
  Session one = station_session();
  one.faults = std::get<0>(sim::read_faults("at 1 ms toaster unplug"));
  CHECK_THROWS_WITH(run(one), "there is no device 'toaster' to go wrong; there are val, alter, force-torque");
  REQUIRE(one.faults.size() == 1);
  CHECK(one.faults[0].line == 1);
}
