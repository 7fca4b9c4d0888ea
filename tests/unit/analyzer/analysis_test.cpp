// A proof that a run contradicts is not used, of no requirement, whichever analysis finds the run.
#include <catch2/catch.hpp>

#include "analyzer/analysis.hpp"
#include "analyzer/compositional/compositional.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/analyzer/small_skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

constexpr Nanoseconds ms = 1'000'000;

/// The response takes 2 ms at most.
std::unique_ptr<test::Skill> two() {
  return test::sound_skill(
      test::small_skill("REQUIREMENT answer : RESPONSE FROM tick OF MC1 TO work AT MOST 5 ms\n"
                        "REQUIREMENT short  : BUSY PERIOD OF P0 AT MOST 5 ms\n",
                        test::worker,
                        "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nTIME work : 1 TO 2 ms\n"
                        "DEVICE MC1 EVENT tick EVERY 10 ms\n"));
}

/// Meets its limits at once.
Analysis gives_up(const Problem& problem, const Options&) {
  Options nothing;
  nothing.max_states = 0;
  Analysis analysis = analyze_exactly(problem, nothing);
  for (Verdict& verdict : analysis.verdicts) {
    verdict.gave_up = true;
    verdict.witness.reset();
  }
  return analysis;
}

/// Says that of the response.
Analysis claims(const Problem& problem, const Options& options, Nanoseconds bound) {
  Analysis analysis = compositional::analyze(problem, options);
  analysis.verdicts[0].state = VerdictState::holds;
  analysis.verdicts[0].bound = Duration(bound);
  return analysis;
}

Provers wrong(Nanoseconds bound) {
  return {gives_up, [bound](const Problem& problem, const Options& options) {
            return claims(problem, options, bound);
          }};
}

}  // namespace

TEST_CASE("a bound that no run contradicts is the verdict's bound") {
  const auto skill = two();
  const Analysis analysis = analyze_with(wrong(2 * ms), *skill->problem, AnalysisChoice::automatic);
  CHECK(analysis.verdicts[0].state == VerdictState::holds);
  CHECK(analysis.verdicts[0].bound == Duration(2 * ms));
  CHECK(analysis.verdicts[1].state == VerdictState::holds);
  CHECK(analysis.verdicts[1].bound == Duration(2 * ms));
}

TEST_CASE("a run found by the search withdraws all verdicts of the proof that it contradicts") {
  const auto skill = two();
  for (const AnalysisChoice choice : {AnalysisChoice::thorough}) {
    const Analysis analysis = analyze_with(wrong(2 * ms - 1), *skill->problem, choice);
    for (const Verdict& verdict : analysis.verdicts) {
      INFO(verdict.requirement);
      CHECK(verdict.state == VerdictState::undecided);
      CHECK_FALSE(verdict.bound);
      CHECK_FALSE(verdict.exact);
      CHECK(verdict.addends.empty());
      CHECK(verdict.explanation.text().find(
                "contradicts what the compositional analysis proved of 'answer'") != std::string::npos);
    }
    CHECK(attained(analysis.verdicts[0]) == Duration(2 * ms));
  }
}

// The exact analysis shows 4 ms where the other one said 3: what that said of the busy period is not used.
TEST_CASE("a run found by the exploration withdraws all verdicts of the proof that it contradicts") {
  const auto skill = two();
  Provers provers = wrong(3 * ms);
  provers.exact = [](const Problem& problem, const Options& options) {
    Analysis analysis = gives_up(problem, options);
    if (options.max_states < 1'000'000) return analysis;
    Verdict& verdict = analysis.verdicts[0];
    verdict.gave_up = false;
    verdict.state = VerdictState::holds;
    verdict.bound = Duration(4 * ms);
    verdict.exact = true;
    verdict.witness.emplace();
    verdict.witness->measured.value = 4 * ms;
    return analysis;
  };
  const Analysis analysis = analyze_with(provers, *skill->problem, AnalysisChoice::thorough);
  CHECK(analysis.verdicts[0].method == Method::exact);
  CHECK(analysis.verdicts[0].bound == Duration(4 * ms));
  CHECK(analysis.verdicts[1].state == VerdictState::undecided);
  CHECK_FALSE(analysis.verdicts[1].bound);
  CHECK(analysis.verdicts[1].explanation.text().find("proved of 'answer'") != std::string::npos);
}

TEST_CASE("a value that no statement reads is never measured, by any analysis") {
  const auto skill = test::sound_skill(
      test::small_skill("REQUIREMENT unread : AGE OF pc-high AT work AT MOST 5 ms\n"
                        "REQUIREMENT read   : AGE OF pc-high AT SPC( pc-high ) AT MOST 9 ms\n",
                        R"(
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    REPEAT
      WTM( tick from MC1 )
      work
    UNTIL( forever )
  END
  BEGIN
    REPEAT
      WTM( stop from MC2 )
      SPC( pc-high )
    UNTIL( pc-high )
  END
  END CONCURRENT
  TXM( Completion Protocol 0 )
END
)",
                        "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nTIME work : 1 TO 2 ms\nCOST SET 1 ms\n"
                        "DEVICE MC1 EVENT tick EVERY 10 ms\nDEVICE MC2 EVENT stop EVERY 7 ms\n"));
  for (const AnalysisChoice choice :
       {AnalysisChoice::exact, AnalysisChoice::compositional, AnalysisChoice::automatic}) {
    const Analysis analysis = analyze(*skill->problem, choice);
    CHECK(analysis.verdicts[0].state == VerdictState::never);
    CHECK(analysis.verdicts[0].explanation.text() == "no run gets there with a value that it has read");
    CHECK_FALSE(analysis.verdicts[0].bound);
    CHECK(analysis.verdicts[1].state != VerdictState::never);
  }
}

TEST_CASE("a run of a thousand events refutes a duration even if nothing could be explored") {
  std::string works;
  for (int n = 0; n < 1000; ++n) works += "  work\n";
  const auto skill = test::sound_skill(
      test::small_skill("REQUIREMENT whole : DURATION TO COMPLETION 0 AT MOST 999 ms\n",
                        "Skill Module: SM1\n  ACTIVITY work\nBEGIN\n  WTM( Coordinator )\n" + works +
                            "  TXM( Completion Protocol 0 )\nEND\n",
                        "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nTIME work : 1 ms\n"));
  Options none;
  none.max_states = 1;
  const Analysis analysis = analyze(*skill->problem, AnalysisChoice::automatic, none);
  const Verdict& verdict = analysis.verdicts.front();
  CHECK(verdict.state == Verdict::State::fails);
  REQUIRE(verdict.witness);
  CHECK(verdict.witness->measured.value == 1000 * ms);
}

TEST_CASE("what holds by a bound is not looked at further, but for a moment's exploration and a few runs") {
  const auto skill = two();
  std::size_t most = 0;
  Provers provers{
      [&](const Problem& problem, const Options& options) {
        most = std::max(most, options.max_states);
        return gives_up(problem, options);
      },
      [](const Problem& problem, const Options& options) { return claims(problem, options, 2 * ms); }};
  const Analysis quick = analyze_with(provers, *skill->problem, AnalysisChoice::automatic);
  CHECK(quick.verdicts[0].state == VerdictState::holds);
  CHECK(quick.verdicts[0].exact);  // by one of a few runs
  CHECK(most <= 20'000);
  // They are a few for all requirements together: of many each has none.
  Problem many = *skill->problem;
  many.requirements.assign(11, many.requirements.front());
  const Analysis of_many = analyze_with(provers, many, AnalysisChoice::automatic);
  CHECK(of_many.verdicts[0].state == VerdictState::holds);
  CHECK_FALSE(of_many.verdicts[0].witness);
  CHECK(most <= 20'000);
  const Analysis thorough = analyze_with(provers, *skill->problem, AnalysisChoice::thorough);
  CHECK(thorough.verdicts[0].exact);
}

TEST_CASE("a long row of losses is bounded by shorter ones") {
  const auto skill =
      test::sound_skill(test::small_skill("REQUIREMENT half : LOSS OF MC1 AT MOST 16 IN 32\n"
                                          "REQUIREMENT few  : LOSS OF MC1 AT MOST 15 IN 31\n",
                                          test::worker,
                                          "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nTIME work : 1 TO 15 ms\n"
                                          "DEVICE MC1 EVENT tick EVERY 10 ms\n"));
  std::size_t rows = 0;
  Provers provers{[&](const Problem& problem, const Options& options) {
                    for (const Requirement& each : problem.requirements)
                      rows = std::max<std::size_t>(rows, static_cast<std::size_t>(each.in));
                    return analyze_exactly(problem, options);
                  },
                  [](const Problem& problem, const Options& options) {
                    return compositional::analyze(problem, options);
                  }};
  const Analysis analysis = analyze_with(provers, *skill->problem, AnalysisChoice::automatic);
  CHECK(analysis.verdicts[0].state == VerdictState::holds);
  CHECK(analysis.verdicts[0].bound <= Duration(16));
  CHECK(analysis.verdicts[0].requirement == "half");
  CHECK(analysis.verdicts[1].requirement == "few");
  CHECK(rows <= 31);
}

TEST_CASE("requirements that measure the same share their bounds") {
  const auto skill = test::sound_skill(
      test::small_skill("REQUIREMENT one   : RESPONSE FROM tick OF MC1 TO work AT MOST 5 ms\n"
                        "REQUIREMENT other : RESPONSE FROM tick OF MC1 TO work AT MOST 4 ms\n",
                        test::worker,
                        "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nTIME work : 1 TO 2 ms\n"
                        "DEVICE MC1 EVENT tick EVERY 10 ms\n"));
  // The other one is never decided by itself.
  Provers provers{gives_up, [](const Problem& problem, const Options& options) {
                    Analysis analysis = claims(problem, options, 2 * ms);
                    analysis.verdicts[1].state = VerdictState::undecided;
                    analysis.verdicts[1].bound.reset();
                    return analysis;
                  }};
  Options none;
  none.max_states = 0;
  const Analysis analysis = analyze_with(provers, *skill->problem, AnalysisChoice::automatic, none);
  CHECK(analysis.verdicts[1].state == VerdictState::holds);
  CHECK(analysis.verdicts[1].bound == Duration(2 * ms));
  CHECK(analysis.verdicts[1].limit == Duration(4 * ms));
  CHECK(analysis.verdicts[1].requirement == "other");
}
