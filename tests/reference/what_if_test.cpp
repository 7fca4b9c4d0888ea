// Slack that can be reckoned by hand, and how many processors figure 3.6 needs.
#include <catch2/catch.hpp>

#include "analyzer/whatif/placement.hpp"
#include "analyzer/whatif/slack.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;

namespace {

std::unique_ptr<test::Skill> figure(const std::string& file) {
  return test::skill_from_files({PAL_SOURCE_DIR "/tests/reference/" + file});
}

Options few_states() {
  Options options;
  options.max_states = 100'000;
  return options;
}

/// What the exact analysis says of all requirements when the worst time of `name` is so much longer.
Verdict::State with(const test::Skill& skill, const std::string& name, Duration extra) {
  pan::Environment environment = skill.specification.environments.front();
  find_figure(environment, name)->worst += extra;
  Diagnostics diagnostics;
  const auto problem = make_problem(skill.specification.skills.front(), environment, diagnostics);
  REQUIRE(problem);
  Verdict::State worst = Verdict::State::holds;
  for (const Verdict& verdict : analyze_exactly(*problem, few_states()).verdicts) {
    if (verdict.state == Verdict::State::undecided && worst == Verdict::State::holds) worst = verdict.state;
    if (verdict.state == Verdict::State::fails) worst = verdict.state;
  }
  return worst;
}

/// A round of 10 ms. One activity is done before and again after SPC( half ). `late` allows it 1.5 ms more,
/// and the other 3 ms. `early` allows either 2 ms more.
const char* const two_intervals = R"(MESSAGE tick : SIGNAL
MESSAGE value : SIGNAL
CONDITION half FROM value "half of a round is done"
CONDITION whole FROM value "a round is done"
SKILL s
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT late  : INTERVAL OF SPC( whole ) IN SM1 AT MOST 13 ms
  REQUIREMENT early : INTERVAL OF SPC( half ) IN SM1 AT MOST 12 ms
END SKILL
Machine Controller: MC1
Skill Module: SM1
  ACTIVITY first
  ACTIVITY again
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    first
    again
    SPC( half )
    again
    SPC( whole )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  DEVICE MC1 EVENT tick EVERY 10 ms
  PLACE SM1 ON P0 PRIORITY 1
  TIME first OF SM1 : 1 ms
  TIME again OF SM1 : 1 ms
END ENVIRONMENT
)";

}  // namespace

// The last of three drivers, 5 of 40 ms, must end within 26 ms; above it are 3 of 7 and 3 of 12. The time
// demand (J. Lehoczky, L. Sha, Y. Ding, The rate monotonic scheduling algorithm, 1989) must fit at some point
// before a release or the deadline: 7, 12, 14, 21, 24, 26. For each activity the best point is 21: 3 C1 + 2
// C2 + C3 <= 21, so C1 may be 10/3, C2 3.5 and C3 6. A tick at the very instant of the end may come first
// here, so the two that are whole nanoseconds must stay one below.
TEST_CASE("slack of rate monotonic drivers is what the time demand leaves, to the nanosecond") {
  const auto skill = figure("rate_monotonic.pal");
  REQUIRE(skill->problem);
  const auto all =
      slacks(skill->specification.skills.front(), skill->specification.environments.front(), few_states());
  const auto of = [&](const std::string& name) {
    for (const Slack& slack : all) {
      if (slack.figure == name) return slack;
    }
    throw std::runtime_error("no figure " + name);
  };
  for (const auto& [name, nanoseconds] :
       {std::pair{"work-1", 333'333}, {"work-2", 499'999}, {"work-3", 999'999}}) {
    INFO(name);
    const Slack slack = of(name);
    CHECK(slack.exact());
    CHECK(slack.holds == Duration(nanoseconds));
    CHECK(slack.fails == Duration(nanoseconds + 1));
    CHECK(slack.requirement == RequirementId(2));
    // The same, asked of the exact analysis.
    CHECK(with(*skill, name, *slack.holds) == Verdict::State::holds);
    CHECK(with(*skill, name, *slack.fails) == Verdict::State::fails);
  }
  CHECK(of("SEND").unlimited);  // no statement sends
  // All together: 5 ms is the longest; the others grow in proportion, rounded up.
  const Slack together = of("");
  CHECK(together.exact());
  for (const Duration extra : {*together.holds, *together.fails}) {
    pan::Environment environment = skill->specification.environments.front();
    for (pan::ActivityTime& each : environment.activities) {
      const std::int64_t worst = each.time.worst.count();
      each.time.worst += Duration((worst * extra.count() + 4'999'999) / 5'000'000);
    }
    Diagnostics diagnostics;
    const auto problem = make_problem(skill->specification.skills.front(), environment, diagnostics);
    REQUIRE(problem);
    const auto verdicts = analyze_exactly(*problem, few_states()).verdicts;
    const bool hold = std::all_of(verdicts.begin(), verdicts.end(),
                                  [](const auto& each) { return each.state == Verdict::State::holds; });
    CHECK(hold == (extra == *together.holds));
  }
}

TEST_CASE("slack is nothing where a requirement does not hold as things are") {
  const auto skill = figure("rate_monotonic.pal");
  pan::Environment environment = skill->specification.environments.front();
  REQUIRE(change(environment, "work-3 = 7 ms").empty());
  for (const Slack& slack : slacks(skill->specification.skills.front(), environment, few_states())) {
    CHECK_FALSE(slack.holds);
    CHECK(slack.requirement == RequirementId(2));
  }
}

TEST_CASE("the slack of a load is exact for times without a common divisor") {
  const auto skill = test::sound_skill(R"(MESSAGE tick : SIGNAL
SKILL s
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT headroom : LOAD OF EACH PROCESSOR AT MOST 50 %
END SKILL
Machine Controller: MC1
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    work
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  DEVICE MC1 EVENT tick EVERY 12000001 ns
  PLACE SM1 ON P0 PRIORITY 1
  TIME work OF SM1 : 1 TO 3999999 ns
  COST RECEIVE 999983 ns
END ENVIRONMENT
)");
  const auto all =
      slacks(skill->specification.skills.front(), skill->specification.environments.front(), few_states());
  int seen = 0;
  for (const Slack& slack : all) {
    INFO(slack.figure);
    if (slack.figure.rfind("work", 0) != 0 && slack.figure != "RECEIVE") continue;
    ++seen;
    CHECK(slack.exact());
    CHECK(slack.holds == Duration(1'000'018));  // to 6,000,000 ns in 12,000,001 ns
    CHECK(slack.requirement == RequirementId(0));
  }
  CHECK(seen == 2);
}

// Two requirements fail at different growths. When the second figure is searched, runs of both are already
// known. The requirement that fails with less growth is named.
TEST_CASE("a slack names the requirement that fails first") {
  const auto skill = test::sound_skill(two_intervals);
  const auto all =
      slacks(skill->specification.skills.front(), skill->specification.environments.front(), few_states());
  REQUIRE(all.size() > 2);
  CHECK(all[0].figure == "first OF SM1");
  CHECK(all[0].exact());
  CHECK(all[0].holds == Duration(2'000'000));
  CHECK(all[0].requirement == RequirementId(1));
  CHECK(all[1].figure == "again OF SM1");
  CHECK(all[1].exact());
  CHECK(all[1].holds == Duration(1'500'000));
  CHECK(all[1].requirement == RequirementId(0));
}

// 1000 ns and 10 ns grow by x and a hundredth of it. A whole nanosecond is more than a hundredth of nine:
// with the 10 ns that early leaves, x is 9.
TEST_CASE("figures that grow together are rounded up, each for itself") {
  std::string text = two_intervals;
  for (const auto& [old, better] : {std::pair<std::string, std::string>{"13 ms", "20 ms"},
                                    {"12 ms", "10000010 ns"},
                                    {"first OF SM1 : 1 ms", "first OF SM1 : 1000 ns"},
                                    {"again OF SM1 : 1 ms", "again OF SM1 : 10 ns"}}) {
    text.replace(text.find(old), old.size(), better);
  }
  const auto skill = test::sound_skill(text);
  const Slack together =
      slacks(skill->specification.skills.front(), skill->specification.environments.front(), few_states())
          .back();
  CHECK(together.figure.empty());
  CHECK(together.exact());
  CHECK(together.holds == Duration(9));
  CHECK(together.requirement == RequirementId(1));
}

TEST_CASE("an undecided question counts neither as holds nor as fails") {
  const auto skill = test::sound_skill(two_intervals);
  Options options;
  options.max_states = 5;
  for (const Slack& slack :
       slacks(skill->specification.skills.front(), skill->specification.environments.front(), options)) {
    const bool first = slack.figure == "first OF SM1";
    if (!first && slack.figure != "again OF SM1") continue;
    const Duration most(first ? 2'000'000 : 1'500'000);
    CHECK_FALSE(slack.unlimited);
    if (slack.holds) CHECK(*slack.holds <= most);
    if (slack.fails) CHECK(*slack.fails > most);
  }
}

TEST_CASE("an event that is never answered leaves no slack") {
  const auto skill = test::sound_skill(R"(MESSAGE tick : SIGNAL
MESSAGE value : SIGNAL
CONDITION wanted FROM value "it is wanted"
SKILL s
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT soon : RESPONSE FROM tick OF MC1 TO answer IN SM1 AT MOST 5 ms
END SKILL
Machine Controller: MC1
Skill Module: SM1
  ACTIVITY answer
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    SPC( wanted = FALSE )
    CASE
      ( wanted ):
        answer
      ( NOT( wanted ) ):
        Do Nothing
    END CASE
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  DEVICE MC1 EVENT tick EVERY 10 ms
  PLACE SM1 ON P0 PRIORITY 1
  TIME answer OF SM1 : 1 ms
END ENVIRONMENT
)");
  for (const Slack& slack :
       slacks(skill->specification.skills.front(), skill->specification.environments.front(), few_states())) {
    CHECK_FALSE(slack.holds);
    CHECK(slack.requirement == RequirementId(0));
  }
}

TEST_CASE("where no time passes any more there is no slack") {
  const auto skill = test::sound_skill(R"(MESSAGE tick : SIGNAL
SKILL s
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT brief : BUSY PERIOD OF EACH PROCESSOR AT MOST 5 ms
END SKILL
Machine Controller: MC1
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 ) WITHIN 0 ms
      work
    ELSE
      Do Nothing
    END WTM
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  DEVICE MC1 EVENT tick EVERY 10 ms
  PLACE SM1 ON P0 PRIORITY 1
  TIME work OF SM1 : 1 ms
END ENVIRONMENT
)");
  for (const Slack& slack :
       slacks(skill->specification.skills.front(), skill->specification.environments.front(), few_states()))
    CHECK_FALSE(slack.holds);
}

TEST_CASE("an interrupted search says only what was proved") {
  const auto skill = figure("rate_monotonic.pal");
  Options options = few_states();
  int asked = 0;
  options.stop = [&asked] { return ++asked > 40; };
  for (const Slack& slack :
       slacks(skill->specification.skills.front(), skill->specification.environments.front(), options)) {
    INFO(slack.figure);
    if (!slack.holds || slack.figure.empty()) continue;
    if (slack.figure == "work-1") CHECK(*slack.holds <= Duration(333'333));
    if (slack.figure == "work-1" && slack.fails) CHECK(*slack.fails > Duration(333'333));
  }
}

// Section 3.3.2.1 says that the skill of figure 3.6 requires two processors. A thread that waits needs none;
// so one does, unless the processor itself reads the sensor and cannot be interrupted.
TEST_CASE("figure 3.6 needs two processors only if reading keeps one of them busy") {
  const auto skill = figure("figure_3_6_places.pal");
  PlacementOptions how;
  how.priorities = true;
  for (const pan::Environment& environment : skill->specification.environments) {
    INFO(environment.name);
    RequirementChecker checker(skill->specification.skills.front(), few_states());
    const auto all = fewest_processors(environment, checker, how);
    REQUIRE(all.size() == (environment.name == "reading" ? 2 : 1));
    CHECK_FALSE(all.back().meet.empty());
    if (environment.name != "reading") continue;
    CHECK(all.front().tried == 13);  // every order of three threads, equals included
    CHECK(all.front().refuted.size() == 13);
    CHECK(all.front().complete);
  }
}

TEST_CASE("changes of figures: read, or refused with a reason") {
  const auto skill = figure("rate_monotonic.pal");
  const pan::Environment& before = skill->specification.environments.front();
  const auto changed = [&](const std::string& text) {
    pan::Environment environment = before;
    INFO(text);
    CHECK(change(environment, text) == "");
    return environment;
  };
  CHECK(changed("work-1 = 1..2 ms").activities[0].time == Interval{Duration(1'000'000), Duration(2'000'000)});
  CHECK(changed("work-1 = 500us TO 2 ms").activities[0].time.best == Duration(500'000));
  CHECK(changed("SEND=0.1ms").costs.send.worst == Duration(100'000));
  CHECK(changed("MC1.priority = 7").placements[0].priority == 7);
  CHECK(changed("MC1.processor = P1").placements[0].processor == "P1");
  for (const char* wrong :
       {"work-1", "work-9 = 1 ms", "work-1 = 2..1 ms", "work-1 = soon", "MC1.priority = high",
        "clock-1.collecting = 1 ms", "MC9.processor = P1", "work-1 = -1 ms", "= 1 ms"}) {
    pan::Environment environment = before;
    INFO(wrong);
    CHECK_FALSE(change(environment, wrong).empty());
  }
}

TEST_CASE("an activity with the name of a cost is a figure of its own") {
  const auto skill = figure("rate_monotonic.pal");
  pan::Environment environment = skill->specification.environments.front();
  pan::Network network = skill->specification.skills.front();
  for (auto& time : environment.activities) {
    if (time.activity == "work-1") time.activity = "SEND";
  }
  for (auto& activity : network.activities) {
    if (activity.name == "work-1") activity.name = "SEND";
  }
  const Interval work = environment.activities[0].time;
  const auto all = figures(network, environment);
  REQUIRE(all.front().name == "ACTIVITY SEND");
  CHECK(find_figure(environment, "ACTIVITY SEND") == &environment.activities[0].time);
  CHECK(find_figure(environment, "SEND") == &environment.costs.send);
  CHECK(change(environment, "SEND = 5 us") == "");
  CHECK(environment.activities[0].time == work);
  CHECK(change(environment, "ACTIVITY SEND = 7 us") == "");
  CHECK(environment.activities[0].time == Interval{Duration(7'000), Duration(7'000)});
  CHECK(environment.costs.send.worst == Duration(5'000));
}

TEST_CASE("a change of a hundred thousand digits is refused") {
  const auto skill = figure("rate_monotonic.pal");
  pan::Environment environment = skill->specification.environments.front();
  CHECK_FALSE(change(environment, "work-1 = " + std::string(100'000, '1') + " ms").empty());
}
