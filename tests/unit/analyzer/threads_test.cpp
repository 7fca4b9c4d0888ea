// The threads of modules that are executed: how many, their names, and where they are.
#include <catch2/catch.hpp>
#include <set>

#include "analyzer/compositional/causes/cloned_blocks.hpp"
#include "pal/pan/threads.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

std::string skill(const std::string& method, const std::string& executed, const std::string& places = "") {
  return "MESSAGE light : SIGNAL\nSKILL s\n  MACHINE CONTROLLER MC1\n  SKILL METHOD SM1\n"
         "  CONTINGENCY 1 \"no\" METHOD CM1\n  CONTINGENCY 2 \"never\" METHOD CM2\n"
         "  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n"
         "  REQUIREMENT often : INTERVAL OF work AT MOST 1 s\nEND SKILL\nMachine Controller: MC1\n"
         "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n" +
         method +
         "  TXM( light to MC1 )\n  TXM( Completion Protocol 0 )\nEND\n"
         "Contingency Module: CM1\nBEGIN\n" +
         executed +
         "END\nContingency Module: CM2\n  ACTIVITY work\nBEGIN\n"
         "  CONCURRENT BEGIN work END BEGIN work work END END CONCURRENT\nEND\n"
         "ENVIRONMENT e\n  PROCESSOR P\n  PROCESSOR Q\n  DEVICE MC1 ON REQUEST 1 ms\n"
         "  PLACE SM1 ON P PRIORITY 1\n" +
         places + "  TIME work : 1 ms\nEND ENVIRONMENT\n";
}

std::set<std::string> names(const Problem& problem) {
  std::set<std::string> found;
  for (const Thread& thread : problem.threads) CHECK(found.insert(thread.name).second);
  return found;
}

const Thread& named(const Problem& problem, const std::string& name) {
  for (const Thread& thread : problem.threads) {
    if (thread.name == name) return thread;
  }
  throw std::runtime_error("no thread " + name);
}

const std::string once = "  CONCURRENT BEGIN CM1 END BEGIN CM1 CM1 END END CONCURRENT\n";
const std::string inner = "  CONCURRENT BEGIN CM2 END END CONCURRENT\n  CM2\n";

}  // namespace

TEST_CASE("each thread that executes a module has one set of its blocks, named after it") {
  const auto made = test::sound_skill(skill("  CM1\n" + once + "  CM1\n", inner));
  const std::set<std::string> all = {"SM1",
                                     "SM1.1",
                                     "SM1.2",
                                     "CM1.1",
                                     "CM1.1/CM2.1",
                                     "CM1.1/CM2.2",
                                     "CM2.1",
                                     "CM2.2",
                                     "SM1.1/CM1.1",
                                     "SM1.1/CM1.1/CM2.1",
                                     "SM1.1/CM1.1/CM2.2",
                                     "SM1.1/CM2.1",
                                     "SM1.1/CM2.2",
                                     "SM1.2/CM1.1",
                                     "SM1.2/CM1.1/CM2.1",
                                     "SM1.2/CM1.1/CM2.2",
                                     "SM1.2/CM2.1",
                                     "SM1.2/CM2.2"};
  CHECK(names(*made->problem) == all);
  // The same by the graphs alone.
  std::set<std::string> found;
  for (const pan::SkillThread& thread : pan::threads_of(made->specification.skills.front(), 100)) {
    CHECK(found.insert(thread.name).second);
    const Thread& same = named(*made->problem, thread.name);
    CHECK((same.parent.valid()) == thread.parent.has_value());
  }
  CHECK(found == all);
  CHECK(pan::threads_of(made->specification.skills.front(), 5).size() > 5);
}

TEST_CASE(
    "a block of an executed module runs at its own place, or at that of its name's end, or with its module") {
  const auto made = test::sound_skill(skill(
      once, inner,
      "  PLACE SM1.1 ON Q PRIORITY 2\n  PLACE CM2.1 ON Q PRIORITY 3\n  PLACE CM1.1/CM2.1 ON P PRIORITY 4\n"
      "  PLACE SM1.2/CM1.1/CM2.1 ON Q PRIORITY 5\n  PLACE CM1.1 ON P PRIORITY 6\n"));
  const auto place = [&](const std::string& name) {
    const Thread& thread = named(*made->problem, name);
    return made->problem->processors[thread.processor].name + std::to_string(thread.priority);
  };
  CHECK(place("SM1.1") == "Q2");
  CHECK(place("SM1.2") == "P1");
  CHECK(place("SM1.1/CM1.1") == "P6");
  CHECK(place("SM1.1/CM1.1/CM2.1") == "P4");
  CHECK(place("SM1.2/CM1.1/CM2.1") == "Q5");
  CHECK(place("SM1.1/CM2.1") == "Q3");
  // CM2 is executed in CM1.1, and by SM1.1.
  CHECK(place("SM1.1/CM1.1/CM2.2") == "P6");
  CHECK(place("SM1.1/CM2.2") == "Q2");
}

TEST_CASE("each CONCURRENT begins blocks of its own in the clone without shared blocks") {
  const auto made = test::sound_skill(skill("  CM1\n" + once + "  CM1\n", inner));
  const Problem& problem = *made->problem;
  const Problem cloned = compositional::clone_shared_blocks(problem);
  Table<ThreadId, int> begun(cloned.threads.size());
  for (const Step& step : cloned.steps) {
    for (ThreadId block : step.threads) ++begun[block];
  }
  for (const ThreadId t : cloned.threads.ids()) {
    CHECK(begun[t] == (!cloned.threads[t].parent.valid() ? 0 : 1));
    CHECK(cloned.threads[t].parent < t);
  }
  // Five times CM1, each with its own block and two sets of those of CM2: 5 * ( 1 + 2 * 2 ), SM1 and its two.
  CHECK(cloned.threads.size() == 28);
  REQUIRE(cloned.requirements.front().at.size() == cloned.steps.size());
  for (const StepId s : cloned.steps.ids()) {
    const StatementId statement = cloned.steps[s].statement;
    const bool works = statement.valid() && cloned.statements[statement].text == "work";
    CHECK(cloned.requirements.front().at[s] == works);
  }
  // Where nothing is shared nothing is copied.
  const auto plain =
      test::sound_skill(skill("  CONCURRENT BEGIN CM1 END BEGIN CM1 END END CONCURRENT\n", "  CM2\n"));
  const Problem same = compositional::clone_shared_blocks(*plain->problem);
  CHECK(same.threads.size() == plain->problem->threads.size());
  CHECK(same.steps.size() == plain->problem->steps.size());
}

TEST_CASE("modules whose blocks multiply are refused in time") {
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
  const auto made = test::skill_from_text(text);
  CHECK_FALSE(made->problem);
  CHECK(test::messages(made->diagnostics).find("PAL0730 skill s is too large to analyse") !=
        std::string::npos);
}
