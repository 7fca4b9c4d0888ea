// A skill of one module and what it talks to, with gaps for the test to fill.
#pragma once

#include <string>

namespace pal::test {

inline std::string small_skill(const std::string& requirements, const std::string& modules,
                               const std::string& environment) {
  return R"(
MESSAGE tick : SIGNAL
MESSAGE stop : SIGNAL
MESSAGE value : REAL N
CONDITION pc-high FROM value "high"
SKILL small
  SENSOR DRIVER      NONE
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1, MC2
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "stopped"
  COMPLETION 1 ERROR  "any other error"
)" + requirements +
         R"(
END SKILL
Logical Sensor: LS1
Machine Controller: MC1
Machine Controller: MC2
)" + modules +
         "\nENVIRONMENT cell\n" + environment + "\nEND ENVIRONMENT\n";
}

/// Works for a while on each tick of MC1, and never ends.
inline const char* const worker = R"(
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    work
    SPC( pc-high )
  UNTIL( pc-high )
  TXM( Completion Protocol 0 )
END
)";

}  // namespace pal::test
