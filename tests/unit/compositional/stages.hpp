// The stages of the compositional analysis of one skill, as text, one after the other.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/times/times.hpp"
#include "tests/support/skill.hpp"

namespace pal::test {

constexpr analyzer::Nanoseconds ms = 1'000'000;

inline bool goes_on() {
  return false;
}

/// All that the analysis knows of a skill before it asks for a measure. The skill must be sound.
struct Stages {
  explicit Stages(const std::string& text)
      : skill(sound_skill(text)),
        problem(skill->problem.value()),
        forest(analyzer::compositional::forest_of(problem, goes_on)),
        behaviours(analyzer::compositional::thread_behaviours_of(problem, forest, goes_on)),
        times(analyzer::compositional::times_of(
            problem, forest, behaviours, pal::Table<analyzer::StepId, bool>(problem.steps.size(), true),
            goes_on)),
        context{problem, forest, behaviours} {}
  Stages(const Stages&) = delete;

  analyzer::ThreadId thread(const std::string& name) const {
    for (const analyzer::ThreadId i : problem.threads.ids()) {
      if (problem.threads[i].name == name) return i;
    }
    return analyzer::ThreadId{};
  }
  /// The only node of a thread's jobs.
  analyzer::compositional::NodeId job(const std::string& name) const {
    return behaviours.threads[thread(name)].job_starts.at(0);
  }

  std::unique_ptr<Skill> skill;
  const analyzer::Problem& problem;
  analyzer::compositional::Forest forest;
  analyzer::compositional::ThreadBehaviours behaviours;
  analyzer::compositional::Times times;
  analyzer::compositional::AnalysisContext context;
};

/// A sensor ticks every 20 ms. A logical sensor looks for 1 to 2 ms and tells the skill. The skill works for
/// 3 ms on the same processor. `sm1` is the skill's loop after its start.
inline std::string chain(const std::string& sm1, const std::string& environment = "") {
  return R"(
MESSAGE tick : SIGNAL
MESSAGE value : REAL N
CONDITION pc-high FROM value "high"
SKILL chain
  SENSOR DRIVER      SD1
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER NONE
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "stopped"
  COMPLETION 1 ERROR  "any other error"
END SKILL
Sensor Driver: SD1
Logical Sensor: LS1
  ACTIVITY look WRITES value
BEGIN
  REPEAT
    WTM( tick from SD1 )
    look
    TXM( value to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY work
  ACTIVITY rest
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( value from LS1 )
)" + sm1 +
         R"(
  UNTIL( pc-high )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
PROCESSOR P0
DEVICE SD1 EVENT tick EVERY 20 ms
TIME look : 1 ms TO 2 ms
TIME work : 3 ms
TIME rest : 5 ms
PLACE LS1 ON P0 PRIORITY 2
PLACE SM1 ON P0 PRIORITY 1
)" + environment +
         "END ENVIRONMENT\n";
}

}  // namespace pal::test
