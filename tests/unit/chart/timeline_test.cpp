// Traces as plain data of charts.
#include <catch2/catch.hpp>

#include "analyzer/chart/timeline.hpp"
#include "tests/unit/chart/signs_trace.hpp"
#include "tests/unit/chart/touch_trace.hpp"

namespace pal::analyzer::chart {
namespace {

const Lane& lane(const Timeline& timeline, const std::string& name) {
  for (const Lane& it : timeline.lanes) {
    if (it.name == name) return it;
  }
  throw std::runtime_error("no lane " + name);
}

std::vector<std::string> names(const Timeline& timeline) {
  std::vector<std::string> result;
  for (const Lane& it : timeline.lanes) result.push_back(it.name);
  return result;
}

TEST_CASE("lanes of one processor stand together, and communicating lanes are neighbours") {
  CHECK(names(timeline(touch_trace({}))) ==
        std::vector<std::string>{"alter", "MC1", "SM1", "SM1.2", "SM1.1", "LS1", "SD1", "force-torque"});
}

TEST_CASE("an activity that is preempted is two bars with a ready stretch between") {
  const Timeline found = timeline(signs_trace());
  const Lane& sm1 = lane(found, "SM1");
  REQUIRE(sm1.bars.size() == 6);
  CHECK(sm1.bars[1].text == "plan-path");
  CHECK_FALSE(sm1.bars[1].finished);
  CHECK_FALSE(sm1.bars[1].resumed);
  CHECK(sm1.bars[2].text == "plan-path");
  CHECK(sm1.bars[2].resumed);
  CHECK(sm1.bars[2].finished);
  REQUIRE(sm1.gaps.size() == 1);
  CHECK(sm1.gaps[0].kind == GapKind::ready);
  CHECK(sm1.gaps[0].from_ns == 3'000'000);
  CHECK(sm1.gaps[0].to_ns == 6'000'000);
}

TEST_CASE("a wait says what it waits for, and whether in vain") {
  const Timeline found = timeline(signs_trace());
  REQUIRE(lane(found, "MC1").gaps.size() == 1);
  CHECK(lane(found, "MC1").gaps[0].text == "motion from SM1");
  CHECK(lane(found, "MC1").gaps[0].gave_up);
  REQUIRE(lane(found, "LS1").gaps.size() == 1);
  CHECK(lane(found, "LS1").gaps[0].text == "profile from range-finder");
  CHECK_FALSE(lane(found, "LS1").gaps[0].gave_up);
}

TEST_CASE("a message is an arrow to its take, or is dropped or never delivered") {
  const Timeline found = timeline(signs_trace());
  REQUIRE(found.arrows.size() == 4);
  CHECK(found.arrows[0].message == "request image");
  CHECK(found.arrows[0].fate == Fate::dropped);
  CHECK(found.arrows[1].message == "tick");
  CHECK(found.arrows[1].fate == Fate::undelivered);
  CHECK(found.arrows[2].message == "profile");
  CHECK(found.arrows[2].fate == Fate::taken);
  CHECK(found.arrows[2].to_ns == 3'000'000);
  CHECK(found.arrows[2].taken_ns == 3'500'000);
  CHECK(found.arrows[3].fate == Fate::undelivered);
}

TEST_CASE(
    "what a device works at is named by the message that comes of it, what it says of itself is an event") {
  const Timeline found = timeline(signs_trace());
  REQUIRE(lane(found, "range-finder").bars.size() == 1);
  CHECK(lane(found, "range-finder").bars[0].text == "profile");
  std::vector<std::string> events;
  for (const Mark& mark : found.marks) {
    if (mark.kind == MarkKind::event) events.push_back(mark.text);
  }
  CHECK(events == std::vector<std::string>{"tick"});
}

TEST_CASE("conditions show the threads that set and read them") {
  const Timeline found = timeline(signs_trace());
  REQUIRE(found.waveforms.size() == 1);
  const Waveform& wave = found.waveforms[0];
  REQUIRE(wave.sets.size() == 1);
  CHECK(wave.sets[0].value);
  CHECK(found.lanes[static_cast<std::size_t>(wave.sets[0].lane)].name == "SM1");
  REQUIRE(wave.reads.size() == 1);
  CHECK(found.lanes[static_cast<std::size_t>(wave.reads[0].lane)].name == "MC1");
}

TEST_CASE("bars and gaps of a lane never overlap, whatever the run") {
  for (std::int64_t tick = 0; tick < 28'000'000; tick += 1'700'000) {
    TouchRun run;
    run.read_first = tick % 2 == 0;
    run.tick_ns = tick;
    const Timeline found = timeline(touch_trace(run));
    for (const Lane& it : found.lanes) {
      std::vector<std::pair<std::int64_t, std::int64_t>> spans;
      for (const Bar& bar : it.bars) spans.emplace_back(bar.from_ns, bar.to_ns);
      for (const Gap& gap : it.gaps) spans.emplace_back(gap.from_ns, gap.to_ns);
      std::sort(spans.begin(), spans.end());
      for (std::size_t i = 1; i < spans.size(); ++i) REQUIRE(spans[i - 1].second <= spans[i].first);
    }
  }
}

}  // namespace
}  // namespace pal::analyzer::chart
