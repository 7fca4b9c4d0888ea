// Skills that no plan is made of.
#include "codegen/plan.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "tests/unit/check/specification.hpp"

using namespace pal;

TEST_CASE("a skill whose blocks multiply beyond what can be generated is refused") {
  std::string text =
      "MESSAGE light : SIGNAL\nSKILL s\n  MACHINE CONTROLLER MC1\n  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n"
      "  COMPLETION 1 ERROR\n";
  std::string modules;
  for (int m = 0; m < 24; ++m) {
    const std::string name = "CM" + std::to_string(m);
    const std::string call = m == 23 ? "work" : "Execute CM" + std::to_string(m + 1);
    text += "  CONTINGENCY " + std::to_string(m + 1) + " \"no\" METHOD " + name + "\n";
    modules += "Contingency Module: " + name + (m == 23 ? "\n  ACTIVITY work" : "") +
               "\nBEGIN\n  CONCURRENT BEGIN " + call + " END BEGIN " + call + " END END CONCURRENT\nEND\n";
  }
  text +=
      "END SKILL\nMachine Controller: MC1\nSkill Module: SM1\nBEGIN\n  WTM( Coordinator )\n  CM0\n"
      "  TXM( light to MC1 )\n  TXM( Completion Protocol 0 )\nEND\n" +
      modules +
      "ENVIRONMENT e\n  PROCESSOR P\n  DEVICE MC1 ON REQUEST 1 ms\n  PLACE SM1 ON P PRIORITY 1\n"
      "  TIME work : 1 ms\nEND ENVIRONMENT\n";
  const auto checked = test::check_text(text);
  Diagnostics diagnostics;
  CHECK_FALSE(codegen::make_plan(checked.specification.skills.front(),
                                 checked.specification.environments.front(), checked.sources, diagnostics));
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all().front().message == "skill s has more threads than can be generated");
}
