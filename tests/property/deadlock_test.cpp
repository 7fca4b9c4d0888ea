// What the search for deadlocks says of a skill is what trying everything says.
#include <catch2/catch.hpp>
#include <iostream>

#include "pal/check/deadlock/explore.hpp"
#include "tests/support/random_talk.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/talk_oracle.hpp"
#include "tests/support/talking_skill.hpp"

using namespace pal;
using namespace pal::check;
using pal::test::setting;
using pal::test::talking_skill;

namespace {

test::TalkOracle::Length length(const std::vector<deadlock::Action>& run, std::size_t actions) {
  test::TalkOracle::Length result{0, 0};
  for (std::size_t i = 0; i < actions; ++i) {
    const bool timely =
        run[i].kind == deadlock::Action::Kind::gives_up || run[i].kind == deadlock::Action::Kind::loses;
    result.first += timely ? 1 : 0;
    result.second += is_talk(run[i]) ? 1 : 0;
  }
  return result;
}

struct Seen {
  int compared = 0, total = 0, partial = 0, undelivered = 0, untaken = 0, without_values = 0;
};

struct Blurred {
  int compared = 0, decided = 0, dead = 0;
};

void expect_same_findings(const deadlock::Findings& found, const test::TalkOracle::Result& expected,
                          Seen& seen) {
  if (found.overflowed) return;
  ++seen.compared;
  seen.without_values += found.without_values ? 1 : 0;
  CAPTURE(found.without_values);
  REQUIRE(found.complete);
  REQUIRE(found.total.has_value() == expected.total.has_value());
  if (expected.total) {
    ++seen.total;
    const auto shortest = length(found.total->run, found.total->decided);
    CHECK(shortest.first == expected.total->first);
    CHECK(shortest.second == expected.total->second);
    CHECK(found.total->timely == (expected.total->first > 0));
  }
  const bool partial = expected.dead && (!expected.total || expected.dead->first < expected.total->first);
  REQUIRE(found.partial.has_value() == partial);
  if (partial) {
    ++seen.partial;
    CHECK(length(found.partial->run, found.partial->decided) == *expected.dead);
  }
  std::set<std::size_t> untaken;
  for (const auto channel : found.untaken) untaken.insert(channel.index());
  CHECK(untaken == expected.untaken);
  std::map<std::size_t, test::TalkOracle::Length> undelivered;
  for (const auto& one : found.undelivered)
    undelivered[one.channel.index()] = length(one.run, one.run.size());
  CHECK(undelivered == expected.undelivered);
  seen.untaken += untaken.empty() ? 0 : 1;
  seen.undelivered += undelivered.empty() ? 0 : 1;
}

/// With the values of conditions from the first state on, and only if they matter.
void expect_same_findings(const pan::Network& network, Seen& seen, std::size_t most_states = 8'000) {
  const auto expected = test::TalkOracle(network, most_states).run();
  if (!expected.complete) return;
  const pan::Flow flow(network);
  const auto automata = deadlock::automata(network, flow);
  deadlock::Limits limits;
  for (const std::size_t at_first : {limits.states, std::size_t{0}}) {
    CAPTURE(at_first);
    limits.at_first = at_first;
    expect_same_findings(deadlock::explore(automata, limits), expected, seen);
  }
}

/// Counting only few withdrawn requests leaves more undecided, and changes nothing of what is said.
void expect_same_findings_blurred(const deadlock::Findings& found, const test::TalkOracle::Result& expected,
                                  Blurred& seen) {
  if (!found.blurred) return;
  ++seen.compared;
  CAPTURE(found.complete, found.without_values);
  if (found.total) {
    REQUIRE(expected.total);
    ++seen.dead;
    CHECK(length(found.total->run, found.total->decided) >=
          *expected.total);  // a shorter one may not be counted
  }
  if (found.partial) {
    REQUIRE(expected.dead);
    ++seen.dead;
  }
  for (const auto channel : found.untaken) CHECK(expected.untaken.contains(channel.index()));
  for (const auto& one : found.undelivered) CHECK(expected.undelivered.contains(one.channel.index()));
  if (!found.complete) return;
  ++seen.decided;
  CHECK(found.total.has_value() == expected.total.has_value());
  const bool partial = expected.dead && (!expected.total || expected.dead->first < expected.total->first);
  if (partial) CHECK(found.partial.has_value());
  CHECK(found.undelivered.size() == expected.undelivered.size());
}

void expect_same_findings_blurred(const pan::Network& network, Blurred& seen) {
  const auto expected = test::TalkOracle(network, 8'000).run();
  if (!expected.complete) return;
  const pan::Flow flow(network);
  const auto automata = deadlock::automata(network, flow);
  deadlock::Limits limits;
  for (limits.withdrawn = 0; limits.withdrawn <= 2; ++limits.withdrawn) {
    for (const std::size_t at_first : {limits.states, std::size_t{0}}) {
      CAPTURE(limits.withdrawn, at_first);
      limits.at_first = at_first;
      expect_same_findings_blurred(deadlock::explore(automata, limits), expected, seen);
    }
  }
}

/// All searches of one kind together may look at few states only: what they then say to be all is all.
void expect_same_findings_short(const pan::Network& network, Seen& seen, int& undecided) {
  const auto expected = test::TalkOracle(network, 2'000).run();
  if (!expected.complete) return;
  const pan::Flow flow(network);
  const auto automata = deadlock::automata(network, flow);
  deadlock::Limits limits;
  for (limits.shared = 0; limits.shared < 60; ++limits.shared) {
    CAPTURE(limits.shared);
    const auto found = deadlock::explore(automata, limits);
    if (found.total) REQUIRE(expected.total);
    if (found.partial) REQUIRE(expected.dead);
    for (const auto& one : found.undelivered) CHECK(expected.undelivered.contains(one.channel.index()));
    undecided += found.complete ? 0 : 1;
    if (found.complete) expect_same_findings(found, expected, seen);
  }
}

/// The search is told to end after so many questions. What it has found by then is so; what it says to be all
/// is all.
void expect_same_findings_stopped(const pan::Network& network, Seen& seen, int& stopped) {
  const auto expected = test::TalkOracle(network, 2'000).run();
  if (!expected.complete) return;
  const pan::Flow flow(network);
  const auto automata = deadlock::automata(network, flow);
  for (const int most : {0, 1, 3, 7, 15, 40, 100, 300}) {
    CAPTURE(most);
    int asked = 0;
    deadlock::Limits limits;
    limits.at_first = most % 2 == 0 ? limits.at_first : 0;
    limits.stop = [&asked, most] { return ++asked > most; };
    const auto found = deadlock::explore(automata, limits);
    if (found.total) REQUIRE(expected.total);
    if (found.partial) REQUIRE(expected.dead);
    for (const auto& one : found.undelivered) CHECK(expected.undelivered.contains(one.channel.index()));
    stopped += found.stopped ? 1 : 0;
    if (found.complete) expect_same_findings(found, expected, seen);
  }
}

void report(const Seen& seen) {
  std::cout << "compared " << seen.compared << ", deadlocks " << seen.total << ", waits for ever "
            << seen.partial << ", undelivered " << seen.undelivered << ", untaken " << seen.untaken
            << ", whatever the conditions " << seen.without_values << "\n";
}

}  // namespace

TEST_CASE("leaving out orders of moves changes nothing that is found") {
  const auto seeds = setting("PAL_ROUNDS", 30);
  const auto first = setting("PAL_SEED", 1);
  Seen seen;
  for (auto seed = first; seed < first + seeds; ++seed) {
    CAPTURE(seed);
    const auto text = test::RandomTalk(seed).text();
    INFO(text);
    if (const auto skill = talking_skill(text)) expect_same_findings(*skill, seen);
  }
  CAPTURE(seen.compared, seen.total, seen.partial, seen.undelivered, seen.untaken, seen.without_values);
  CHECK(seen.compared > static_cast<int>(seeds));
  CHECK(seen.without_values > static_cast<int>(seeds / 10));
  CHECK(seen.total > static_cast<int>(seeds / 4));
  CHECK(seen.partial > static_cast<int>(seeds / 20));
  CHECK(seen.undelivered > static_cast<int>(seeds / 20));
  report(seen);
}

TEST_CASE("blocks within blocks that are cancelled change nothing that is found") {
  const auto seeds = setting("PAL_ROUNDS", 20);
  const auto first = setting("PAL_SEED", 1);
  Seen seen;
  for (auto seed = first; seed < first + seeds; ++seed) {
    CAPTURE(seed);
    const auto text = test::RandomNest(seed).text();
    INFO(text);
    if (const auto skill = talking_skill(text)) expect_same_findings(*skill, seen, 12'000);
  }
  CAPTURE(seen.compared, seen.total, seen.partial, seen.undelivered, seen.untaken, seen.without_values);
  CHECK(seen.compared > static_cast<int>(seeds / 2));
  CHECK(seen.without_values > static_cast<int>(seeds / 20));
  CHECK(seen.total > static_cast<int>(seeds / 15));
  CHECK(seen.partial > static_cast<int>(seeds / 30));
  CHECK(seen.undelivered > static_cast<int>(seeds / 15));
  report(seen);
}

TEST_CASE("a search that has used up the common limit is not complete") {
  Seen seen;
  int undecided = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    for (const std::string& text : {test::RandomTalk(seed).text(), test::RandomNest(seed).text()}) {
      INFO(text);
      if (const auto skill = talking_skill(text)) expect_same_findings_short(*skill, seen, undecided);
    }
  }
  CAPTURE(seen.compared, seen.partial, seen.undelivered);
  CHECK(undecided > 100);
  CHECK(seen.partial > 100);
  CHECK(seen.undelivered > 50);
}

TEST_CASE("a search that is stopped claims nothing about unseen states") {
  Seen seen;
  int stopped = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    for (const std::string& text : {test::RandomTalk(seed).text(), test::RandomNest(seed).text()}) {
      INFO(text);
      if (const auto skill = talking_skill(text)) expect_same_findings_stopped(*skill, seen, stopped);
    }
  }
  CAPTURE(seen.compared, seen.total);
  CHECK(stopped > 100);
  CHECK(seen.total > 10);
}

// One block takes a request and another sends the answer: which of them is first makes a difference.
TEST_CASE("a request is taken and answered in two orders") {
  Seen seen;
  const auto skill = talking_skill(test::RandomTalk(5841).text());
  REQUIRE(skill);
  expect_same_findings(*skill, seen);
  CHECK(seen.total == seen.compared);
}

// LS1 answers every first of two requests. The blocks may ask and be answered while the other one works; then
// the next request is not answered.
TEST_CASE("work of a block before it cancels others gives them time") {
  for (const std::string work : {"look", "SPC( unread )"}) {
    const auto skill = talking_skill(R"(CONDITION unread
MESSAGE value : SIGNAL
SKILL s
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
END SKILL
Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request value from SM1 )
    TXM( value to SM1 )
    WTM( request value from SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY look
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    REPEAT
      TXM( request value from LS1 )
      WTM( value from LS1 )
    UNTIL( forever )
  END
  BEGIN
)" + work + R"(
  END
  END CONCURRENT
  TXM( request value from LS1 )
  WTM( value from LS1 )
  TXM( Completion Protocol 0 )
END
)");
    INFO(work);
    REQUIRE(skill);
    Seen seen;
    expect_same_findings(*skill, seen);
    CHECK(seen.compared == 2);
    CHECK(seen.total == 2);
  }
}

// The sensor answers in some runs and in others never, whereas the robot goes on in all of them.
TEST_CASE("a search without values finds a wait whose end depends on a value") {
  const std::string text = R"(CONDITION gate
MESSAGE raw : SIGNAL
MESSAGE value : SIGNAL
MESSAGE motion : SIGNAL
SKILL s
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
END SKILL
Sensor Driver: SD1
BEGIN
  REPEAT
    WTM( request raw from LS1 )
    TXM( raw to LS1 )
  UNTIL( forever )
END
Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request value from SM1 )
    REPEAT
      TXM( request raw from SD1 )
      WTM( raw from SD1 )
    UNTIL( gate )
    TXM( value to SM1 )
  UNTIL( forever )
END
Machine Controller: MC1
BEGIN
  REPEAT
    TXM( request motion from SM1 )
    WTM( motion from SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  SPC( gate )
  CONCURRENT
  BEGIN
    TXM( request value from LS1 )
    WTM( value from LS1 )
  END
  BEGIN
    REPEAT
      WTM( request motion from MC1 )
      TXM( motion to MC1 )
    UNTIL( forever )
  END
  END CONCURRENT
  TXM( Completion Protocol 0 )
END
)";
  const auto skill = talking_skill(text);
  REQUIRE(skill);
  Seen seen;
  expect_same_findings(*skill, seen);
  CHECK(seen.compared == 2);
  CHECK(seen.partial == 2);
}

TEST_CASE("withdrawn requests beyond the count do not change what is decided") {
  const auto seeds = setting("PAL_ROUNDS", 20);
  const auto first = setting("PAL_SEED", 1);
  Seen seen;
  Blurred blurred;
  for (auto seed = first; seed < first + seeds; ++seed) {
    for (const auto& text :
         {test::RandomPolling(seed).text(), test::RandomTalk(seed).text(), test::RandomNest(seed).text()}) {
      CAPTURE(seed);
      INFO(text);
      const auto skill = talking_skill(text);
      if (!skill) continue;
      expect_same_findings(*skill, seen);
      expect_same_findings_blurred(*skill, blurred);
    }
  }
  CAPTURE(blurred.compared, blurred.decided, blurred.dead);
  CHECK(blurred.compared > static_cast<int>(seeds / 2));
  CHECK(blurred.decided > static_cast<int>(seeds / 4));
  CHECK(blurred.dead > static_cast<int>(seeds / 20));
  report(seen);
  std::cout << "blurred " << blurred.compared << ", of these decided " << blurred.decided
            << ", dead ends found " << blurred.dead << "\n";
}
