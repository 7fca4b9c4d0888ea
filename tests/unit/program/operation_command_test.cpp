// pal operation check: what it reads, and how it names what it found.
#include <nlohmann/json.hpp>

#include "tests/unit/program/program.hpp"

using namespace pal;
using test::Answer;

namespace {

constexpr const char* blink = R"(MESSAGE light : on : BOOLEAN

SKILL blink
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
  REQUIREMENT done : DURATION TO COMPLETION 0 AT MOST 1 ms
END SKILL

Machine Controller: MC1

Skill Module: SM1
BEGIN
  WTM( Coordinator )
  TXM( light to MC1 )
  TXM( Completion Protocol 0 )
END
)";

std::string environment(const std::string& name, const std::string& cost) {
  return "ENVIRONMENT " + name +
         "\n  PROCESSOR P0\n  PLACE SM1 ON P0 PRIORITY 1\n  DEVICE MC1 ON REQUEST 1 ms\n" + "  COST SEND " +
         cost + "\n  COST RECEIVE 0.05 ms\nEND ENVIRONMENT\n";
}

MemoryFileSystem files_with(const std::string& icons) {
  MemoryFileSystem files;
  files.add(
      "walk.op.json",
      R"({"operation-format": 1, "name": "walk", "icons": [{"id": "start", "kind": "start", "next": "a"}, )" +
          icons + R"(, {"id": "done", "kind": "exit"}, {"id": "bad", "kind": "exit", "code": 1}]})");
  files.add("skills/blink.pal", blink);
  files.add("skills/fast.pal", environment("fast", "0.05 ms"));
  files.add("skills/slow.pal", environment("slow", "5 ms"));
  return files;
}

constexpr const char* blinking =
    R"({"id": "a", "kind": "skill", "skill": "blink", "next": "done", "error": "bad"})";

}  // namespace

TEST_CASE("an operation's skills are proved in the environment that was asked for, and in no other") {
  const MemoryFileSystem files = files_with(blinking);
  const auto check = [&](const std::string& cell) {
    return test::pal({"operation", "check", "walk.op.json", "--skills", "skills", "--environment", cell},
                     files);
  };
  const Answer fast = check("skills/fast.pal");
  INFO(fast.out << fast.err);
  CHECK(fast.status == program::ExitStatus::all_hold);
  CHECK(fast.out.find("slow") == std::string::npos);
  CHECK(check("skills/slow.pal").status == program::ExitStatus::not_met);
  CHECK(check("./skills/../skills/fast.pal").status == program::ExitStatus::all_hold);
}

TEST_CASE("a finding as JSON names the operation and the icon") {
  const auto findings = [](const std::string& icon) {
    const MemoryFileSystem files = files_with(icon);
    const Answer answer =
        test::pal({"operation", "check", "walk.op.json", "--skills", "skills", "--format", "json"}, files);
    INFO(answer.out << answer.err);
    return nlohmann::json::parse(answer.out).at("diagnostics");
  };
  const auto wrong =
      findings(R"({"id": "a", "kind": "skill", "skill": "blonk", "next": "done", "error": "bad"})");
  REQUIRE(wrong.size() == 1);
  CHECK(wrong.at(0).at("operation") == "walk");
  CHECK(wrong.at(0).at("icon") == "a");
  const auto refused = findings(R"({"id": "a", "kind": "skil", "next": "done"})");
  REQUIRE_FALSE(refused.empty());
  CHECK(refused.at(0).at("operation") == "walk");
  CHECK(refused.at(0).at("icon") == "a");
}
