// Findings of texts and drawings: each is told by its text, of a file that has it. So are notes.
#include <catch2/catch.hpp>
#include <string>

#include "tests/unit/check/specification.hpp"

using namespace pal;

namespace {

struct Given {
  std::string text;
  const char* message;
};

/// The ways of a module with a start `s` and an end `e`.
std::string module(const std::string& ways) {
  return "digraph { pal_module=SM1; s [pal_kind=start]; e [pal_kind=end]; " + ways + "}";
}

void expect_findings(const std::string& file, const std::vector<Given>& list) {
  for (const Given& given : list) {
    MemoryFileSystem files;
    files.add(file, given.text);
    const auto checked = test::check_files(files, {file});
    CAPTURE(given.text.substr(0, 300), given.message);
    std::string found;
    for (const Diagnostic& each : checked.diagnostics.all()) {
      found += each.message + "\n";
      for (const Note& note : each.notes) found += note.text + "\n";
    }
    CAPTURE(found);
    CHECK(found.find(std::string(given.message) + "\n") != std::string::npos);
  }
}

}  // namespace

TEST_CASE("what is not DOT is told") {
  std::string nodes;
  std::string many;
  for (int i = 0; i < 500; ++i) nodes += "n" + std::to_string(i) + " ";
  for (int i = 0; i <= 100'000; ++i) many += "n" + std::to_string(i) + " ";
  expect_findings(
      "a.dot",
      {
          {"digraph { /* a", "this comment has no end"},
          {"digraph { a [label=\"x", "this text has no closing quote"},
          {"digraph { a [label=<x", "this '<' has no '>'"},
          {"graph { }", "a graph without directions is no program"},
          {"a -> b", "'digraph' is expected"},
          {"digraph { } digraph { }", "nothing is expected after the graph"},
          {"digraph { a -- b }", "'->' is expected: the ways of a program have directions"},
          {"digraph { subgraph x { } subgraph x { } }", "a subgraph of this name stands before"},
          {"digraph { pc-force [pal_kind=start] }", "a name is expected"},
          {"digraph " + std::string(300, '{') + std::string(300, '}'), "subgraphs are nested too deeply"},
          {"digraph { {" + nodes + "} -> {" + nodes + "} }", "the graph has more than 200000 edges"},
          {"digraph { " + many + "}", "the graph has more than 100000 nodes"},
          {module("n [pal_kind=nothing]; s -> n; n -> e; n -> s"), "the first one is here"},
      });
}

TEST_CASE("nodes that are no statements are told") {
  expect_findings(
      "a.dot",
      {
          {"digraph { s [pal_kind=start] }", "the graph does not name its module"},
          {module("n [pal_kind=wait pal_message=\"a;b\" pal_sender=LS1]; s -> n -> e"),
           "this wait names 2 messages and 1 senders"},
          {module(
               "n [pal_kind=perform pal_activity=think pal_reads=a]; m [pal_kind=perform pal_activity=think "
               "pal_reads=b]; s -> n -> m -> e"),
           "activity 'think' reads or writes other messages here"},
          {module(
               "n [pal_kind=perform pal_activity=think pal_reads=a]; m [pal_kind=perform pal_activity=think "
               "pal_reads=b]; s -> n -> m -> e"),
           "than here"},
          {module("n [pal_kind=sing]; s -> n -> e"), "there is no kind 'sing' of node"},
          {module("n [pal_kind=nothing pal_code=1]; s -> n -> e"),
           "a node of kind 'nothing' has no pal_code"},
          {module("n [pal_kind=perform pal_activity=MESSAGE]; s -> n -> e"),
           "'MESSAGE' begins a unit of PAL and names no activity"},
          {module("n [pal_kind=set pal_condition=c pal_value=maybe]; s -> n -> e"),
           "'maybe' is neither TRUE nor FALSE"},
          {module("n [pal_kind=complete pal_code=many]; s -> n -> e"),
           "'many' is not a number that fits here"},
          {module("n [pal_kind=repeat]; u [pal_kind=until pal_guard=\"a AND\"]; s -> n -> u -> e; u -> n"),
           "'a AND' is no condition of PAL"},
          {"digraph { pal_module=SM1; pal_activities=\"think READS\"; s [pal_kind=start]; e [pal_kind=end]; "
           "s -> "
           "e }",
           "'think READS' is no activity"},
          {"digraph { pal_module=SM1; pal_module_kind=robot; s [pal_kind=start]; e [pal_kind=end]; s -> e }",
           "'robot' is no kind of module"},
      });
}

TEST_CASE("edges that make no program are told") {
  std::string loops;
  std::string ways = "s";
  for (int i = 0; i < 250; ++i) {
    const std::string n = std::to_string(i);
    loops += "r" + n + " [pal_kind=repeat] u" + n + " [pal_kind=until]\n";
    ways += " -> r" + n;
  }
  const std::string wait =
      "n [pal_kind=wait pal_message=\"a;b\" pal_sender=\"LS1;LS1\"]; x [pal_kind=nothing]; m "
      "[pal_kind=merge]; ";
  expect_findings(
      "a.dot",
      {
          {"digraph { pal_module=SM1; e [pal_kind=end] }", "the module begins nowhere"},
          {module("t [pal_kind=start]; s -> e; t -> e"), "the module begins twice"},
          {module("n [pal_kind=nothing]; s -> e"), "no way leads to this node"},
          {module("n [pal_kind=nothing]; s -> n"), "no way leads on from this node"},
          {module("n [pal_kind=nothing]; s -> n -> e; n -> e"),
           "a second edge leaves this node, but the node does not split"},
          {module("r [pal_kind=repeat]; u [pal_kind=until pal_guard=a]; s -> r -> u -> e"),
           "no way leads from this 'until' back to its 'repeat'"},
          {module("r [pal_kind=repeat]; u [pal_kind=until]; s -> r -> u -> e; u -> r"),
           "nothing follows a loop that goes on for ever"},
          {module("m [pal_kind=merge]; s -> m -> e"), "what ends here was never begun"},
          {module("n [pal_kind=nothing]; o [pal_kind=nothing]; s -> n -> o -> n"),
           "two ways meet here that no split began, or a loop closes without 'repeat' and 'until'"},
          {module("g [pal_kind=guard pal_guard=a]; s -> g -> e"), "a node of kind 'guard' cannot stand here"},
          {module("n [pal_kind=nothing]; s -> n -> s"),
           "two ways meet here that no split began, or a loop closes without 'repeat' and 'until'"},
          {module("c [pal_kind=case]; m [pal_kind=merge]; s -> c -> m -> e; c -> m"),
           "what follows a 'case' is the condition of an arm"},
          {module("c [pal_kind=case]; s -> c"), "no way leads on from this node"},
          {module(wait + "s -> n -> m -> e"), "this wait has 1 way out and needs 2"},
          {module(wait + "s -> n; n -> x -> m -> e; n -> m; n -> m"), "this wait has 3 ways out and needs 2"},
          {module("r [pal_kind=repeat]; s -> r -> e"), "this 'repeat' comes to no 'until'"},
          {module("c [pal_kind=concurrent]; n [pal_kind=nothing]; s -> c; c -> n -> e; c -> e"),
           "the ways out of this node do not come together in one 'join'"},
          {module("c [pal_kind=concurrent]; r [pal_kind=repeat]; u [pal_kind=until]; s -> c -> r -> u -> r"),
           "this 'concurrent' comes to no 'join'"},
          {module(loops + ways + " -> e"), "statements are nested deeper than 200"},
      });
}

TEST_CASE("signs, figures and slots that do not fit are told") {
  std::string signs;
  for (int i = 0; i < 101; ++i) signs += "@\n";
  const std::string sensor = R"(
MESSAGE wrench : fz : REAL N
Sensor Driver: SD1
Sensor Driver: SD2
Logical Sensor: LS1
  SENSOR DRIVER SD2
  RETURNS wrench
BEGIN
  REPEAT
    TXM( request wrench from SD1 )
    WTM( wrench from SD1 )
  UNTIL( forever )
END
SKILL s
  SENSOR DRIVER SD1, SD2
  LOGICAL SENSOR LS1
  SKILL METHOD SM1, SM2
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
END SKILL
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  TXM( Completion Protocol 0 )
END
Skill Module: SM2
BEGIN
  WTM( Coordinator )
END
)";
  expect_findings("a.pal",
                  {{"SKILL s\n  PARAMETER angle : REAL deg DEFAULT 5° RANGE 1 TO 9 \"x\"\nEND SKILL\n",
                    "units are written in letters"},
                   {signs, "too many unexpected characters; the rest of this file is not reported"},
                   {"ENVIRONMENT cell\n  PROCESSOR P0\n  DEVICE camera FRAMES EVERY 10 ms COLLECTING 0 "
                    "ms\nEND ENVIRONMENT\n",
                    "a frame is collected in no time"},
                   {sensor, "'LS1' also talks with 'SD1'"},
                   {sensor, "'LS1' never returns 'wrench'"},
                   {sensor, "two modules of skill 's' wait for the coordinator"},
                   {sensor, "this is the other"}});
}

TEST_CASE("why a statement is never reached is told") {
  const auto skill = [](const std::string& body, const std::string& more = "") {
    return "CONDITION c\nSKILL s\n  SKILL METHOD SM1\n  CONTINGENCY 1 \"no\" METHOD CM1\n"
           "  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\nEND SKILL\nSkill Module: SM1\n  ACTIVITY a\nBEGIN\n"
           "  WTM( Coordinator )\n  SPC( c )\n" +
           body + "  TXM( Completion Protocol 0 )\nEND\nContingency Module: CM1\n  ACTIVITY b\nBEGIN\n" +
           more + "END\n";
  };
  const std::string loop = "REPEAT\n a\n UNTIL( forever )\n";
  expect_findings("a.pal",
                  {{skill(loop), "this loop never ends"},
                   {skill("Execute CM1\n", "REPEAT\n b\n UNTIL( forever )\n"), "this module never ends"},
                   {skill("CONCURRENT BEGIN " + loop + "END BEGIN " + loop + "END END CONCURRENT\n"),
                    "no block of this CONCURRENT can end"},
                   {skill("CASE\n ( c = TRUE ):\n" + loop + "( c = FALSE ):\n" + loop + "END CASE\n"),
                    "no branch of this ends"}});
}

TEST_CASE("a text of too many words and signs is read to a limit") {
  std::string signs;
  signs.reserve(4'000'100);
  while (signs.size() < 4'000'020) signs += "a ";
  expect_findings("a.pal", {{signs,
                             "the file cannot be read from here on: it has more than 2000000 words and "
                             "signs"}});
}

TEST_CASE("a search for deadlocks that cannot be finished says why") {
  const std::string text =
      "MESSAGE m : SIGNAL\nSKILL s\n  LOGICAL SENSOR LS1\n  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n"
      "  COMPLETION 1 ERROR\nEND SKILL\nLogical Sensor: LS1\nBEGIN\n  REPEAT\n    WTM( request m from SM1 )\n"
      "    WTM( request m from SM1 )\n    TXM( m to SM1 )\n  UNTIL( forever )\nEND\nSkill Module: "
      "SM1\nBEGIN\n"
      "  WTM( Coordinator )\n  REPEAT\n    TXM( request m from LS1 )\n    TXM( request m from LS1 )\n"
      "    WTM( m from LS1 )\n  UNTIL( forever )\nEND\n";
  expect_findings("a.pal", {{text,
                             "skill 's' can have more than 12 requests for one message open at once, or "
                             "withdrawn and yet to be answered: a deadlock could not be excluded"}});
  MemoryFileSystem files;
  files.add("a.pal", text);
  test::Checked checked;
  const auto trees = check::read_sources(files, checked.sources, {"a.pal"}, checked.diagnostics);
  check::check(trees, checked.diagnostics, [] { return true; });
  REQUIRE_FALSE(checked.diagnostics.all().empty());
  CHECK(checked.diagnostics.all().back().message ==
        "skill 's' was not searched for deadlocks to the end: the time ran out");
}
