// What was not checked is not green, in any form of a report.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/unit/program/program.hpp"

namespace pal::test {
namespace {

using Json = nlohmann::json;
using program::ExitStatus;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string press = R"(MESSAGE force : REAL N
CONDITION pressed FROM force
SKILL press
  LOGICAL SENSOR LS1
  SKILL METHOD   SM1
  REQUIREMENT brisk : INTERVAL OF WTM( force from LS1 ) AT MOST 6 ms
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
END SKILL
Logical Sensor: LS1
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    TXM( request force from LS1 )
    WTM( force from LS1 )
    SPC( pressed )
  UNTIL( pressed )
  TXM( Completion Protocol 0 )
END
)";
const std::string bench = R"(ENVIRONMENT bench
  PROCESSOR P0
  DEVICE LS1 ON REQUEST 5 TO 6 ms
  PLACE SM1 ON P0 PRIORITY 1
END ENVIRONMENT
)";

std::string without(std::string text, const std::string& line) {
  const auto at = text.find(line);
  text.erase(at, text.find('\n', at) + 1 - at);
  return text;
}

Answer check(const std::string& text, std::vector<std::string> options) {
  options.insert(options.begin(), {"check", "s.pal"});
  return pal(options, in_memory(text));
}

Json sarif_run(const Answer& answer) {
  return Json::parse(answer.out).at("runs").at(0);
}

}  // namespace

TEST_CASE("a requirement without an environment is not green in any form") {
  const Answer text = check(press, {});
  CHECK(text.status == ExitStatus::not_met);
  CHECK(has(text.out, "not checked  brisk: no environment was given"));
  CHECK(has(check(press, {"--quiet"}).err, "no time was checked"));

  const Answer json = check(press, {"--format", "json"});
  CHECK(json.status == ExitStatus::not_met);
  const Json document = Json::parse(json.out);
  REQUIRE(document.at("requirements").size() == 1);
  const Json& row = document.at("requirements").at(0);
  CHECK(row.at("verdict") == "not checked");
  CHECK(row.at("reason") == "no environment was given");
  CHECK(row.at("limit_ns") == 6'000'000);
  CHECK(row.at("measure") == "interval");

  const Answer junit = check(press, {"--format", "junit"});
  CHECK(junit.status == ExitStatus::not_met);
  CHECK(has(junit.out, "<skipped message=\"not checked: no environment was given\">"));
  CHECK(has(junit.out, "skipped=\"1\""));

  const Json run = sarif_run(check(press, {"--format", "sarif"}));
  const Json& invocation = run.at("invocations").at(0);
  CHECK(invocation.at("exitCode") == 3);
  CHECK(invocation.at("exitCodeDescription") == "no requirement was checked");
  CHECK(invocation.at("toolExecutionNotifications").at(0).at("level") == "warning");
}

TEST_CASE("an option makes what was not checked an error: --require-verdicts") {
  const Answer text = check(press, {"--require-verdicts"});
  CHECK(text.status == ExitStatus::not_met);
  CHECK(has(text.err, "error[PAL0892]: 'brisk' of press was not checked: no environment was given"));
  CHECK(has(check(press, {"--require-verdicts", "--format", "junit"}).out, "<error type=\"PAL0892\""));
  const Json run = sarif_run(check(press, {"--require-verdicts", "--format", "sarif"}));
  CHECK(run.at("results").at(0).at("ruleId") == "PAL0892");
  CHECK(run.at("results").at(0).at("locations").size() == 1);
  CHECK(check(press + bench, {"--require-verdicts"}).status == ExitStatus::all_hold);
  CHECK(check(press, {"--require-verdicts", "--without-times"}).status == ExitStatus::usage);
}

TEST_CASE("an environment alone, and a skill that requires nothing, prove nothing") {
  const std::string idle = without(press, "  REQUIREMENT brisk");
  CHECK(check(bench, {}).status == ExitStatus::not_met);
  CHECK(has(check(bench, {}).err, "there is no SKILL"));
  CHECK(check(idle + bench, {}).status == ExitStatus::not_met);
  CHECK(has(check(idle + bench, {}).out, "not checked  the skill has no REQUIREMENT"));
  CHECK(check(idle + bench, {"--without-times"}).status == ExitStatus::all_hold);
  CHECK(check(bench, {"--require-verdicts"}).status == ExitStatus::not_met);
  CHECK(has(check(bench, {"--require-verdicts"}).err, "error[PAL0892]: nothing was checked: "));
  // Beside a skill that has one it is a warning in words, and an error if asked for.
  std::string both =
      press + bench + idle.substr(idle.find("SKILL press"), idle.find("Logical") - idle.find("SKILL press"));
  both.replace(both.rfind("SKILL press"), 11, "SKILL other");
  CHECK(check(both, {}).status == ExitStatus::all_hold);
  CHECK(has(check(both, {}).err, "skill 'other' was not checked"));
  CHECK(check(both, {"--require-verdicts"}).status == ExitStatus::not_met);
}

TEST_CASE("a file that cannot be read has a place and a case of its own") {
  MemoryFileSystem files;
  files.add("s.pal", press + bench);
  const Answer junit = pal({"check", "s.pal", "gone.pal", "--format", "junit"}, files);
  CHECK(junit.status == ExitStatus::usage);
  CHECK(has(junit.out, "name=\"s.pal\" time=\"0.000\"/>"));
  CHECK(has(junit.out, "name=\"gone.pal\" time=\"0.000\">\n      <error type=\"PAL0111\""));
  for (const std::vector<std::string>& given :
       {std::vector<std::string>{"gone.pal"}, {"s.pal", "gone.pal"}}) {
    std::vector<std::string> arguments{"check", "--format", "sarif"};
    arguments.insert(arguments.end(), given.begin(), given.end());
    const Json result = sarif_run(pal(arguments, files)).at("results").at(0);
    const Json& place = result.at("locations").at(0).at("physicalLocation");
    CHECK(place.at("artifactLocation").at("uri") == "gone.pal");
    CHECK(place.at("region").at("startLine") == 1);
  }
}

TEST_CASE("a failure in JUnit has the place, the parts and the hint, and one case is red") {
  std::string late = press + bench;
  late.replace(late.find("AT MOST 6"), 9, "AT MOST 5");
  const Answer answer = check(late, {"--format", "junit"});
  CHECK(has(answer.out, "failures=\"1\""));
  CHECK(has(answer.out, "(s.pal:6)\">error[PAL0890]"));
  CHECK(has(answer.out, "hint: "));
  CHECK(has(answer.out, "--&gt; s.pal:6:"));
  const Answer never = check(without(press, "  REQUIREMENT")
                                     .insert(press.find("  REQUIREMENT"),
                                             "  REQUIREMENT ends : DURATION TO COMPLETION 1 AT MOST 1 s\n") +
                                 bench,
                             {"--format", "junit"});
  CHECK(has(never.out, "<error type=\"PAL0816\""));
  CHECK(has(never.out, "says nothing"));
  CHECK(never.out.find("<error ") == never.out.rfind("<error "));
  CHECK_FALSE(has(never.out, "<failure "));
}

TEST_CASE("a warning can be made an error, in every form") {
  const std::string warned = press + "MESSAGE spare : SIGNAL\n" + bench;
  CHECK(check(warned, {}).status == ExitStatus::all_hold);
  const Answer answer = check(warned, {"--warnings-as-errors"});
  CHECK(answer.status == ExitStatus::wrong_specification);
  CHECK(has(answer.err, "error[PAL0217]"));
  CHECK(has(check(warned, {"--warnings-as-errors", "--format", "junit"}).out, "<failure type=\"PAL0217\""));
  CHECK(sarif_run(check(warned, {"--warnings-as-errors", "--format", "sarif"}))
            .at("results")
            .at(0)
            .at("level") == "error");
}

TEST_CASE("each rule of a SARIF log says where its page is") {
  const Json run = sarif_run(check("CONDITION $\n", {"--format", "sarif"}));
  CHECK(has(run.at("tool").at("driver").at("rules").at(0).at("helpUri"), "diagnostics.md#pal01"));
}

TEST_CASE("no text and no name of a file makes a form ill-formed") {
  const std::string odd = "DEVICE d \"\uFFFE\uFFFF\x01\"\n$\uFFFE\n";
  for (const char* form : {"junit", "json", "sarif"}) {
    MemoryFileSystem files;
    const std::string name = "n\xFF\x01<.pal";
    files.add(name, odd);
    const Answer answer = pal({"check", name, "--format", form}, files);
    CAPTURE(form, answer.out);
    CHECK(answer.status == ExitStatus::wrong_specification);
    if (std::string(form) != "junit") CHECK_NOTHROW(Json::parse(answer.out));
    if (std::string(form) != "junit") continue;
    CHECK_FALSE(has(answer.out, "\uFFFE"));
    CHECK_FALSE(has(answer.out, "\uFFFF"));
    CHECK_FALSE(has(answer.out, "\xFF\x01"));
    CHECK(has(answer.out, "&lt;.pal"));
  }
}

/// A low thread works until the high one is released again.
const std::string two_rates = R"(MESSAGE off : SIGNAL
DEVICE switch
MESSAGE fast : SIGNAL
DEVICE quick
MESSAGE slow : SIGNAL
DEVICE lazy
SKILL rates
  MACHINE CONTROLLER High, Low, Stopper
  SKILL METHOD SM1
  REQUIREMENT soon : RESPONSE FROM slow OF lazy TO work IN Low AT MOST 4 ms
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
END SKILL
Machine Controller: High
  ACTIVITY work
BEGIN
  REPEAT
    WTM( fast from quick )
    work
  UNTIL( forever )
END
Machine Controller: Low
  ACTIVITY work
BEGIN
  REPEAT
    WTM( slow from lazy )
    work
  UNTIL( forever )
END
Machine Controller: Stopper
BEGIN
  WTM( off from switch )
  TXM( off to SM1 )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( off from Stopper )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR idle
  DEVICE switch EVENT off SPORADIC 1 s
  DEVICE quick EVENT fast EVERY 4 ms
  DEVICE lazy EVENT slow EVERY 100 ms
  PLACE High ON P0 PRIORITY 2
  PLACE Low ON P0 PRIORITY 1
  PLACE Stopper ON idle PRIORITY 2
  PLACE SM1 ON idle PRIORITY 1
  TIME work : 2 ms
END ENVIRONMENT
)";

TEST_CASE("half-open bounds are named as such in every form, and closed ones are not") {
  const Answer closed = check(two_rates, {"--analysis", "compositional"});
  CHECK(closed.status == ExitStatus::not_met);  // PAL leaves the order at 4 ms open: 6 ms
  CHECK_FALSE(has(closed.out, "half-open"));
  const Answer text = check(two_rates, {"--analysis", "half-open"});
  INFO(text.out << text.err);
  CHECK(text.status == ExitStatus::all_hold);
  CHECK(has(text.out, "<= 4 ms"));
  CHECK(has(text.out, "half-open windows"));
  const Json json = Json::parse(check(two_rates, {"--analysis", "half-open", "--format", "json"}).out);
  CHECK(has(json.at("windows").get<std::string>(), "half-open"));
  CHECK(json.at("requirements").at(0).at("bound_ns") == 4'000'000);
  CHECK(has(check(two_rates, {"--analysis", "half-open", "--format", "junit"}).out, "half-open windows"));
  const Json sarif = sarif_run(check(two_rates, {"--analysis", "half-open", "--format", "sarif"}));
  const Json& told = sarif.at("invocations").at(0).at("toolExecutionNotifications");
  CHECK(std::any_of(told.begin(), told.end(), [](const Json& each) {
    return has(each.at("message").at("text").get<std::string>(), "half-open windows");
  }));
}

TEST_CASE("an undecided row of losses that is too long to be followed is told as one") {
  std::string text = project_file("tests/golden/check/loss_in_hundred.pal");
  const auto begin = text.find("  REQUIREMENT");
  text.replace(begin, text.find("END SKILL") - begin,
               "  REQUIREMENT late : LOSS OF robot AT MOST 7 IN 200\n");
  const Answer answer = check(text, {"--max-states", "2000", "--max-errors", "1"});
  INFO(answer.err);
  CHECK(answer.status == ExitStatus::not_met);
  CHECK(has(answer.err, "'late' is undecided"));
  CHECK(has(answer.err, "hint: a row of more than 100 is only bounded by shorter ones"));
}

}  // namespace pal::test
