// A skill on one processor whose answer is late because of the work beside it.
#pragma once

#include <string>

namespace pal::test {

/// SM1 answers each tick with 2 ms of `answer`; LS1, which goes first, does 5 ms of `heavy` in each round of
/// 20 ms. The answer is there within `limit` or not.
inline std::string two_chains(const std::string& limit) {
  return R"(MESSAGE tick : SIGNAL
MESSAGE tock : SIGNAL
SKILL s
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT soon : RESPONSE FROM tick OF MC1 TO answer IN SM1 AT MOST )" +
         limit + R"(
END SKILL
Sensor Driver: SD1
Machine Controller: MC1
Logical Sensor: LS1
  ACTIVITY heavy
BEGIN
  REPEAT
    WTM( tock from SD1 )
    heavy
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY answer
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    answer
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  DEVICE MC1 EVENT tick EVERY 10 ms
  DEVICE SD1 EVENT tock EVERY 20 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS1 ON P0 PRIORITY 2
  TIME answer OF SM1 : 2 ms
  TIME heavy OF LS1 : 5 ms
END ENVIRONMENT
)";
}

}  // namespace pal::test
