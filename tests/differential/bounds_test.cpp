// Programs that break what the compositional analysis might take for granted.
#include <catch2/catch.hpp>
#include <numeric>

#include "analyzer/compositional/causes/alternatives.hpp"
#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/compositional.hpp"
#include "analyzer/compositional/times/busy_window.hpp"
#include "analyzer/exact/exact.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/differential/by_hand.hpp"
#include "tests/differential/not_below.hpp"
#include "tests/support/any_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using test::program;
using test::replaced;

namespace {

/// The greatest value that a few runs show of the first requirement, and the compositional bound; nothing:
/// there is none.
struct Shown {
  Nanoseconds greatest = 0;
  std::optional<Duration> bound;
  std::string why;
};

Shown show(const std::string& text) {
  const auto skill = test::meaningful_skill(text);
  Shown shown;
  const Analysis analysis = compositional::analyze(*skill->problem);
  shown.bound = analysis.verdicts.front().bound;
  shown.why = analysis.verdicts.front().explanation.text();
  const Watch watch = watch_of(*skill->problem, skill->problem->requirements.front());
  const Machine machine(*skill->problem, watch);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SimulationOptions options;
    options.times = seed % 2 == 0 ? SimulationOptions::Times::extremes : SimulationOptions::Times::random;
    options.seed = seed;
    options.until = 2'000'000'000;
    options.record = false;
    for (const Measurement& measured : simulate(machine, options).measured)
      shown.greatest = std::max(shown.greatest, measured.value);
  }
  return shown;
}

/// A controller that looks for a request after each tick, and a method.
std::string looks(const std::string& limited, const std::string& method, const std::string& measure) {
  return R"(DEVICE robot
MESSAGE tick  : SIGNAL
MESSAGE state : SIGNAL
SKILL looks
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r : )" +
         measure + R"(
END SKILL
Machine Controller: MC1
  ACTIVITY work
BEGIN
  REPEAT
    WTM( tick from robot )
    )" + limited +
         R"(
    work
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY rest
BEGIN
  WTM( Coordinator )
  REPEAT
)" + method +
         R"(  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  PROCESSOR P2
  PLACE MC1 ON P0 PRIORITY 1
  PLACE SM1 ON P1 PRIORITY 1
)" + std::string(method.find("BEGIN") == std::string::npos ? "" : "  PLACE SM1.1 ON P2 PRIORITY 1\n") +
         R"(  TIME work : 1 ms
  TIME rest : 3 TO 6 ms
  COST RECEIVE 1 ms
  DEVICE robot EVENT tick EVERY 100 ms
END ENVIRONMENT
)";
}

const std::string answer_in_time = R"(WTM( request state from SM1 ) WITHIN 5 ms
      TXM( state to SM1 )
    ELSE
      Do Nothing
    END WTM)";

const std::string gives_up = R"(    rest
    TXM( request state from MC1 )
    WTM( state from MC1 ) WITHIN 0.5 ms
      Do Nothing
    ELSE
      Do Nothing
    END WTM
)";

const std::string is_cancelled = R"(    CONCURRENT
    BEGIN
      REPEAT
        rest
        TXM( request state from MC1 )
        WTM( state from MC1 )
      UNTIL( forever )
    END
    BEGIN
      rest
    END
    END CONCURRENT
)";

}  // namespace

TEST_CASE("a limit starts again when a request is withdrawn while it is being taken") {
  // MC1 has begun to receive the request when SM1 gives up: it comes to its wait once more, as often as SM1
  // asks.
  const std::string measure = "RESPONSE FROM tick OF robot TO work AT MOST 100 ms";
  for (const std::string& method : {gives_up, is_cancelled}) {
    const Shown shown = show(looks(answer_in_time, method, measure));
    CHECK(shown.greatest > 8'000'000);
    INFO(shown.why);
    CHECK_FALSE(shown.bound);
  }
}

TEST_CASE("each request that is withdrawn while it is being taken costs a receive") {
  const auto skill = test::meaningful_skill(looks(answer_in_time, gives_up, "LOAD OF P0 AT MOST 10 %"));
  const Verdict bound = compositional::analyze(*skill->problem).verdicts.front();
  // In a round that never ends MC1 receives for 1 ms, for nothing, every 6.5 ms at the least.
  if (bound.bound) CHECK(bound.bound->count() >= 150'000'000);
}

TEST_CASE("a condition keeps the value that a cancelled block gave it") {
  const Shown shown = show(program("bounds/left"));
  CHECK(shown.greatest > 300'000'000);
  if (shown.bound) CHECK(*shown.bound >= Duration(shown.greatest));
}

TEST_CASE("each branch on the way to a busy thread has a slot that fills") {
  // While SM1 waits for LS1 a message of each branch of MC1 comes to it, and MC1 waits with one more and a
  // tick. Then SM1 works for all of them, before SD1 looks.
  const Shown shown = show(program("bounds/branches_pile_up"));
  CHECK(shown.greatest > 6'000'000);
  INFO(shown.why);
  if (shown.bound) CHECK(*shown.bound >= Duration(shown.greatest));
}

TEST_CASE("if jobs begin in several ways, a later job may overtake") {
  // What SD1 sends by LS2 is there at once, and what it sends by LS1 is there 10 ms later. At that instant
  // the next message by LS2 comes as well, and SM1 may take it first.
  CHECK(test::exact_and_not_below(program("bounds/rounds_overtake")) > 20'000'000);
  CHECK(test::exact_and_not_below(program("bounds/reads_overtake")) > 20'000'000);
}

TEST_CASE("the load does not depend on the unit: seconds or milliseconds") {
  // 20 s in every 100 s. In nanoseconds of work for each second that is a product beyond 64 bits.
  for (const std::string unit : {"ms", "s", "min"}) {
    INFO(unit);
    const auto skill = test::meaningful_skill(replaced(program("bounds/slow"), " ms", " " + unit));
    const Verdict bound = compositional::analyze(*skill->problem).verdicts.front();
    REQUIRE(bound.bound);
    CHECK(bound.bound->count() == 200'000'000);
    CHECK(bound.state != Verdict::State::holds);
  }
}

TEST_CASE("a processor that always works has no longest busy period") {
  // Events every microsecond, 100 s of work for each: in 100 s that adds up to more than 64 bits hold.
  std::string text =
      replaced(program("bounds/slow"), "LOAD OF P0 AT MOST 10 %", "BUSY PERIOD OF P0 AT MOST 300 s");
  text = replaced(replaced(text, "100 ms", "1 us"), "20 ms", "100 s");
  const Verdict bound = compositional::analyze(*test::meaningful_skill(text)->problem).verdicts.front();
  CHECK_FALSE(bound.bound);
  CHECK(bound.state != Verdict::State::holds);
}

TEST_CASE("a turn of more than seventy years is a turn") {
  std::string works;
  for (int n = 0; n < 2400; ++n) works += "    work\n";
  const auto skill = test::meaningful_skill(replaced(program("bounds/long"), "    work\n", works));
  const Verdict load = compositional::analyze(*skill->problem).verdicts.front();
  // The rounds come too late for times to be known, so no rate is: not that which a sum beyond 64 bits has.
  CHECK_FALSE(load.bound);
  CHECK(load.state == Verdict::State::undecided);
}

TEST_CASE("a load whose turn has a thousand actions is found in time") {
  // Its linear program has a round of more terms than Z3 minds its limit on time for: it went on for more
  // than ten minutes.
  std::string works;
  for (int n = 0; n < 1400; ++n) works += "    work\n";
  const auto skill = test::meaningful_skill(replaced(program("bounds/long"), "    work\n", works));
  CHECK(analyze_exactly(*skill->problem).verdicts.front().state != Verdict::State::holds);
}

TEST_CASE("all statements of a skill may stand in one row of one module") {
  // Calls within calls, one for each statement, did not find the room.
  std::string works;
  for (int n = 0; n < 28'000; ++n) works += "    short\n";
  const auto skill = test::meaningful_skill(replaced(program("bounds/in_a_row"), "    short\n", works));
  for (const Verdict& each : compositional::analyze(*skill->problem).verdicts) {
    REQUIRE(each.bound);
    CHECK(each.bound->count() >= 28'000'000);
  }
}

TEST_CASE("the compositional analysis asks whether to end at each segment") {
  // Two thousand segments that share a processor take a minute. Five thousand in a row, with two ways on from
  // each, take a minute and a half.
  int asked = 0;
  Options options;
  options.stop = [&asked] { return ++asked > 20; };
  const auto skill = test::meaningful_skill(program("bounds/slow"));
  const Verdict load = compositional::analyze(*skill->problem, options).verdicts.front();
  CHECK(asked > 20);
  CHECK_FALSE(load.bound);
}

TEST_CASE("a busy window among many tasks is given up on request") {
  // Two thousand ways through branches, with three sources on one processor, took half a minute each.
  bool over = false;
  compositional::BusyWindows windows({true}, [&over] { return over; });
  for (int n = 0; n < 2; ++n) {
    compositional::Transaction many;
    many.period = 1'000;
    for (Nanoseconds t = 0; t < 40; ++t) many.tasks.push_back({ProcessorId{0}, 1, 1, t, 0});
    windows.add(many);
  }
  CHECK(windows.finish(compositional::TransactionId{0}, compositional::TaskId{0}, 1, 0) == 80);
  over = true;
  CHECK(windows.finish(compositional::TransactionId{0}, compositional::TaskId{0}, 1, 0) ==
        compositional::never);
  windows.go_on();
  CHECK(windows.finish(compositional::TransactionId{0}, compositional::TaskId{0}, 1, 0) == 80);
}

TEST_CASE("the compositional analysis asks whether to end at each request") {
  // Six thousand requests in one module, beside blocks of twelve thousand statements, took twelve seconds
  // more than they were given.
  const auto skill = test::meaningful_skill(program("bounds/in_turns"));
  CHECK(compositional::forest_of(*skill->problem, [] { return true; }).refusal.text == "it was interrupted");
}

TEST_CASE("the compositional analysis asks whether to end while it looks at ways that multiply") {
  // Sixty modules with 2^8 ways through a round, on one processor, took three seconds more than they were
  // given.
  const auto skill =
      test::meaningful_skill(replaced(program("bounds/branches_pile_up"), "0 TO 95 ms", "5 TO 95 ms"));
  const compositional::Forest forest = compositional::forest_of(*skill->problem, {});
  const auto known = [&](const std::function<bool()>& stop) {
    std::size_t pairs = compositional::alternatives_of(*skill->problem, forest, stop).size();
    for (const auto& others : compositional::never_together(*skill->problem, forest, stop))
      pairs += others.size();
    return pairs;
  };
  CHECK(known({}) > 0);
  CHECK(known([] { return true; }) == 0);
  // A module with 2^14 ways took five seconds more: none of them is looked at any more.
  const compositional::ThreadBehaviours behaviours =
      compositional::thread_behaviours_of(*skill->problem, forest, {});
  const auto earliest = [&](const std::function<bool()>& stop) {
    const auto all = compositional::earliest_releases({*skill->problem, forest, behaviours}, stop);
    return std::accumulate(all.begin(), all.end(), Nanoseconds{0});
  };
  CHECK(earliest({}) > 0);
  CHECK(earliest([] { return true; }) == 0);
}

TEST_CASE("a request that a block took may be answered as soon as the block ends") {
  // Every other answer needs 10 ms of work: SM1 works for 2 ms in every 12 ms, not for 1 ms in every 11 ms.
  const auto skill = test::meaningful_skill(program("bounds/in_turns"));
  const Verdict bound = compositional::analyze(*skill->problem).verdicts.front();
  if (bound.bound) CHECK(bound.bound->count() >= 166'666'666);
}

TEST_CASE("what follows an answer also follows if a block took its request") {
  // MC1 answers the second request after its blocks; the first is the last that its own thread has taken.
  const Shown shown = show(program("bounds/answered_after_block"));
  CHECK(shown.greatest > 50'000'000);
  if (shown.bound) CHECK(*shown.bound >= Duration(shown.greatest));
}

TEST_CASE(
    "why there is no bound: a thread that comes to its statement in every job is not said to pass it by") {
  // The sensor is asked as soon as the last value is filtered. As far as the bounds know, rounds may come as
  // fast as with the least filtering, and each may take the most. So nothing bounds when one is over.
  const auto skill = test::meaningful_skill(program("bounds/polled"));
  const Analysis analysis = compositional::analyze(*skill->problem);
  REQUIRE(analysis.verdicts.size() == 3);
  for (const Verdict& verdict : analysis.verdicts) {
    INFO(verdict.requirement << ": " << verdict.explanation.text());
    CHECK(verdict.explanation.text().find("nothing bounds when SD1") != std::string::npos);
    CHECK_FALSE(verdict.bound);
  }
}

TEST_CASE("why there is no bound: the thread that may skip its statement is named") {
  const auto skill = test::meaningful_skill(replaced(program("bounds/polled"), "    SPC( contact )\n  UNTIL",
                                                     "    CASE\n      ( contact ): Do Nothing\n      ( NOT "
                                                     "contact ): SPC( contact )\n    END CASE\n  UNTIL"));
  const Analysis analysis = compositional::analyze(*skill->problem);
  const std::string why = analysis.verdicts.front().explanation.text();
  INFO(why);
  CHECK(why.find("SD1 need not come to it in every job") != std::string::npos);
}

TEST_CASE("no bound: a block that passes its statement in every job may leave its loop") {
  const auto skill = test::meaningful_skill(program("bounds/leaves"));
  const Analysis analysis = compositional::analyze(*skill->problem);
  CHECK(analysis.verdicts.front().explanation.text().find("SM1.1 may leave its loop") != std::string::npos);
}

TEST_CASE("why there is no bound: the unbounded thread that keeps another waiting is named") {
  const auto skill = test::meaningful_skill(program("served/by_module"));
  const Analysis analysis = compositional::analyze(*skill->problem);
  const auto says = [](const Verdict& verdict) {
    return verdict.explanation.text().find("when LS1 comes to it, since SM1 may still be waiting") !=
           std::string::npos;
  };
  CHECK(std::any_of(analysis.verdicts.begin(), analysis.verdicts.end(), says));
}

TEST_CASE("why there is no bound: the times of a job and of the next one are named") {
  const auto skill = test::meaningful_skill(program("served/outlasts_period"));
  const Analysis analysis = compositional::analyze(*skill->problem);
  INFO(analysis.verdicts.front().explanation.text());
  CHECK(
      analysis.verdicts.front().explanation.text().find(
          "SD1 may still be waiting within one job when the next is due: a job may last until 42 ms, and the "
          "next may be due at 28 ms") != std::string::npos);
}

TEST_CASE("why there is no bound: the clients of a server that waits are named") {
  const auto skill = test::meaningful_skill(program("served/two_clients"));
  const Analysis analysis = compositional::analyze(*skill->problem);
  for (const Verdict& verdict : analysis.verdicts) {
    INFO(verdict.explanation.text());
    CHECK(verdict.explanation.text().find("LS1 serves 2 clients, SM1 and SM2, and waits within its jobs") !=
          std::string::npos);
  }
}

TEST_CASE("the parts of an age say whether the first set or the next is awaited") {
  // Until the first set, 10 + 2 ms after the start at the latest, the value is as old as the skill. Later
  // there are 10 + 2 - 1 ms from a set to the next; if filtering may take no time, as many.
  const auto added_up = [](const std::string& text) {
    const auto skill = test::meaningful_skill(text);
    const Analysis analysis = compositional::analyze(*skill->problem);
    std::string all;
    for (const Addend& each : analysis.verdicts.front().addends)
      all += std::to_string(each.amount / 1'000'000) + " " + each.actor + " " + each.what + "\n";
    return all;
  };
  const std::string text = program("bounds/not_yet_set");
  CHECK(added_up(text) == "10 clock comes for the first time\n2 SD1 runs filter\n3 MC1 runs obey\n");
  CHECK(added_up(replaced(text, "1 TO 2 ms", "0 TO 2 ms")) ==
        "10 clock comes again\n2 SD1 runs filter\n3 MC1 runs obey\n");
}

TEST_CASE("a job may ask again and again a server that answers once") {
  // MC1 comes back to its wait within one round, and what it asks first it is answered: that is no circle of
  // causes. The second request finds the skill at its end, 1 ms after the tick.
  const Shown shown = show(program("bounds/asks_on"));
  INFO(shown.why);
  REQUIRE(shown.bound);
  CHECK(shown.bound->count() == 1'000'000);
  CHECK(shown.greatest <= shown.bound->count());
}
