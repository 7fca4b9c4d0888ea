// Programs with very many of one thing.
#include "analyzer/analysis.hpp"
#include "tests/differential/by_hand.hpp"
#include "tests/support/any_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::bound;
using pal::test::meaningful_skill;

namespace {

/// SM1 calls MC1, and waits for its answer.
constexpr const char* calls = R"(Skill Module: SM1
BEGIN
  WTM( Coordinator )
  TXM( go to MC1 )
  WTM( go from MC1 )
  TXM( Completion Protocol 0 )
END
)";

/// A skill of these controllers whose duration is asked for.
std::string skill_of(const std::string& controllers, const std::string& limit = "1 s") {
  return "SKILL many\n  MACHINE CONTROLLER " + controllers +
         "\n  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n  COMPLETION 2 ERROR\n"
         "  REQUIREMENT r : DURATION TO COMPLETION 0 AT MOST " +
         limit + "\nEND SKILL\n";
}

/// What `each` says of 0 … n-1.
template <class Each>
std::string all(int n, Each each) {
  std::string text;
  for (int i = 0; i < n; ++i) text += each(std::to_string(i));
  return text;
}

std::string messages_of_a_device(int n) {
  return "DEVICE d\nMESSAGE go : SIGNAL\n" +
         all(n, [](const std::string& i) { return "MESSAGE a" + i + " : SIGNAL\n"; });
}

std::string on_one_processor(const std::string& items) {
  return "ENVIRONMENT cell\n  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n" +
         items + "END ENVIRONMENT\n";
}

Analysis analysis_of(const std::string& text) {
  INFO(text);
  return analyze_exactly(*meaningful_skill(text)->problem);
}

}  // namespace

TEST_CASE("latencies within the 201st processor are those within the first") {
  const std::string text =
      std::string(
          "MESSAGE go : SIGNAL\nMachine Controller: MC1\nBEGIN\n  WTM( go from SM1 )\n  TXM( go to SM1 )\n"
          "END\n") +
      calls + skill_of("MC1") + "ENVIRONMENT cell\n" +
      all(201, [](const std::string& i) { return "  PROCESSOR P" + i + "\n"; }) +
      "  PLACE SM1 ON P200 PRIORITY 1\n  PLACE MC1 ON P200 PRIORITY 1\n  LATENCY WITHIN PROCESSOR 3 ms\n"
      "  LATENCY BETWEEN PROCESSORS 4 ms\nEND ENVIRONMENT\n";
  CHECK(bound(text) == 6);
}

TEST_CASE("a device with 33 kinds of request gives each the right answer") {
  // No thread has asked for a0: MC1 waits 15 ms for it, and is slow.
  const std::string text =
      messages_of_a_device(33) +
      "Machine Controller: MC1\n  ACTIVITY slow\nBEGIN\n  WTM( go from SM1 )\n  TXM( request a32 from d )\n"
      "  WTM( a0 from d ) WITHIN 15 ms\n    Do Nothing\n  ELSE\n    slow\n  END WTM\n  WTM( a32 from d )\n"
      "  TXM( go to SM1 )\n" +
      all(32,
          [](const std::string& i) {
            return "  TXM( request a" + i + " from d )\n  WTM( a" + i + " from d )\n";
          }) +
      "END\n" + calls + skill_of("MC1") +
      on_one_processor("  DEVICE d ON REQUEST 10 ms\n  TIME slow : 100 ms\n");
  CHECK(bound(text) == 115);
}

TEST_CASE("the order of answers that no thread waits for is not explored") {
  // 20 answers come at once, and could do so in 20! orders.
  const std::string text =
      messages_of_a_device(20) + "Machine Controller: MC1\nBEGIN\n  WTM( go from SM1 )\n" +
      all(20, [](const std::string& i) { return "  TXM( request a" + i + " from d )\n"; }) +
      all(20, [](const std::string& i) { return "  WTM( a" + i + " from d )\n"; }) +
      "  TXM( go to SM1 )\nEND\n" + calls + skill_of("MC1") +
      on_one_processor("  DEVICE d FRAMES EVERY 10 ms COLLECTING 9 ms PHASE 5 ms\n  COST SEND 1 us\n");
  const Analysis analysis = analysis_of(text);
  CHECK(analysis.verdicts.front().exact);
  CHECK(analysis.verdicts.front().bound == Duration(14'002'000));
}

TEST_CASE("the order of answers is not explored if the waiting threads do not interact") {
  // Ten modules on processors of their own: in 10! orders.
  const auto module = [](const std::string& i) {
    return "Machine Controller: M" + i + "\nBEGIN\n  TXM( request a" + i + " from d )\n  WTM( a" + i +
           " from d )\n  TXM( go to SM1 )\nEND\n";
  };
  const auto place = [](const std::string& i) {
    return "  PROCESSOR P" + i + "\n  PLACE M" + i + " ON P" + i + " PRIORITY 1\n";
  };
  const std::string text =
      messages_of_a_device(10) + all(10, module) + "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n" +
      all(10, [](const std::string& i) { return "  WTM( go from M" + i + " )\n"; }) +
      "  TXM( Completion Protocol 0 )\nEND\n" +
      skill_of("M0" + all(9, [](const std::string& i) { return ", M" + std::to_string(std::stoi(i) + 1); })) +
      "ENVIRONMENT cell\n"
      "  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 1\n" +
      all(10, place) +
      "  DEVICE d FRAMES EVERY 10 ms COLLECTING 9 ms PHASE 5 ms\n  COST SEND 1 us\nEND ENVIRONMENT\n";
  const Analysis analysis = analysis_of(text);
  CHECK(analysis.verdicts.front().exact);
  CHECK(analysis.verdicts.front().bound == Duration(14'002'000));
}

TEST_CASE("a skill that can begin in too many orders is given up") {
  // Twelve modules come to one queue: in 12! orders.
  std::string names;
  std::string bodies;
  std::string waits;
  std::string places;
  for (int i = 0; i < 12; ++i) {
    const std::string name = "M" + std::to_string(i);
    names += (i == 0 ? "" : ", ") + name;
    bodies += "Machine Controller: " + name + "\nBEGIN\n  TXM( go to SM1 )\nEND\n";
    waits += "  WTM( go from " + name + " )\n";
    places += "  PLACE " + name + " ON P PRIORITY 1\n";
  }
  const Analysis analysis =
      analysis_of("MESSAGE go : SIGNAL\n" + bodies + "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n" +
                  waits + "  TXM( Completion Protocol 0 )\nEND\n" + skill_of(names) +
                  "ENVIRONMENT cell\n  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 1\n" + places +
                  "  COST SEND 1 us\nEND ENVIRONMENT\n");
  CHECK(analysis.verdicts.front().state == Verdict::State::undecided);
  CHECK(analysis.verdicts.front().gave_up);
}

TEST_CASE("more requests than can be counted refute nothing") {
  // SM1 withdraws 20 requests after 1 ms, and nothing of them comes: it is over at 10 ms.
  const auto times = [](int n, const std::string& what) {
    std::string text;
    for (int i = 0; i < n; ++i) text += what;
    return text;
  };
  const std::string text =
      "MESSAGE X : SIGNAL\nMESSAGE go : SIGNAL\nCONDITION c\nMachine Controller: MC1\n  ACTIVITY "
      "work\nBEGIN\n" +
      times(20, "  WTM( request X from SM1 )\n") + "  work\n" + times(20, "  TXM( X to SM1 )\n") +
      R"(  TXM( go to SM1 )
END
Skill Module: SM1
  ACTIVITY late
BEGIN
  WTM( Coordinator )
)" + times(20, "  TXM( request X from MC1 )\n") +
      R"(  WTM( X from MC1 ) WITHIN 1 ms
    Do Nothing
  ELSE
    Do Nothing
  END WTM
  REPEAT
    WTM FIRST
      ( X from MC1 ):
        late
        SPC( c = FALSE )
      ( go from MC1 ):
        SPC( c = TRUE )
    END WTM
  UNTIL( c )
  TXM( Completion Protocol 0 )
END
)" + skill_of("MC1", "30 ms") +
      on_one_processor("  TIME work : 10 ms\n  TIME late : 50 ms\n");
  const Analysis analysis = analyze(*meaningful_skill(text)->problem, AnalysisChoice::automatic, {});
  CHECK(analysis.verdicts.front().state == Verdict::State::undecided);
  CHECK_FALSE(analysis.verdicts.front().witness);
}
