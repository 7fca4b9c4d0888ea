// Random skills in which a controller is sent commands that come once, and is at work when they come.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// The text of a skill with its environment. It has three parts:
///
/// - a method that sends commands, asks for motions, waits for them or gives up, and pauses, in some order
///   and once;
/// - a controller that works for each of these in its own way, before it answers or after;
/// - a driver that shares a processor with one of them.
///
/// If the controller gets a command twice, both may wait for each other, and the skill is refused. All times
/// are whole milliseconds. The same seed gives the same text.
class CommandSkill {
 public:
  explicit CommandSkill(std::uint64_t seed) : chance_(seed) {}

  std::string text() {
    return std::string(R"(MESSAGE early : SIGNAL
MESSAGE late : SIGNAL
MESSAGE done : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
DEVICE clock
SKILL commands
  SENSOR DRIVER      SD1
  LOGICAL SENSOR     NONE
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT whole : DURATION TO COMPLETION 0 AT MOST 1 s
  REQUIREMENT works : INTERVAL OF work IN MC1 BETWEEN 1 ms AND 1 s
  REQUIREMENT busy : BUSY PERIOD OF EACH PROCESSOR AT MOST 1 s
  REQUIREMENT driven : RESPONSE FROM tick OF clock TO work IN SD1 AT MOST 1 s
  REQUIREMENT late : RESPONSE FROM late OF SM1 TO TXM( done to SM1 ) AT MOST 1 s
  REQUIREMENT asked : RESPONSE FROM request motion OF SM1 TO TXM( motion to SM1 ) AT MOST 1 s
END SKILL
)") + modules() +
           environment();
  }

 private:
  static std::string number(int n) { return std::to_string(n); }
  std::string time() {
    const int least = chance_(5);
    return number(least) + (chance_(2) == 0 ? " ms" : " TO " + number(least + 1 + chance_(3)) + " ms");
  }

  std::string statement() {
    const std::string limited = "TXM( request motion from MC1 )\nWTM( motion from MC1 ) WITHIN " +
                                number(chance_(6)) + " ms\n  pause\nELSE\n  Do Nothing\nEND WTM\n";
    return chance_.one_of({"TXM( early to MC1 )\n", "TXM( early to MC1 )\n", "TXM( late to MC1 )\n",
                           "pause\n", "pause\n", asked_, limited, answered_});
  }

  std::string modules() {
    std::vector<std::string> statements{"TXM( early to MC1 )\n", asked_, answered_};
    for (int i = 1 + chance_(5); i > 0; --i) statements.push_back(statement());
    for (std::size_t i = statements.size(); i > 1; --i)
      std::swap(statements[i - 1], statements[static_cast<std::size_t>(chance_(static_cast<int>(i)))]);
    std::string method;
    for (const std::string& each : statements) method += each;
    return R"(Sensor Driver: SD1
  ACTIVITY work
BEGIN
REPEAT
WTM( tick from clock )
work
UNTIL( forever )
END
Machine Controller: MC1
  ACTIVITY work
  ACTIVITY think
BEGIN
REPEAT
WTM FIRST
( early from SM1 ):
)" + chance_.one_of({"work\n", "think\n", "work\nthink\n"}) +
           "( late from SM1 ):\nwork\n" + "TXM( done to SM1 )\n( request motion from SM1 ):\n" +
           chance_.one_of({"work\n", "Do Nothing\n"}) + "TXM( motion to SM1 )\n" +
           chance_.one_of({"work\n", "think\n", "Do Nothing\n"}) + R"(END WTM
UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY pause
BEGIN
WTM( Coordinator )
)" + method +
           "pause\nTXM( Completion Protocol 0 )\nEND\n";
  }

  std::string environment() {
    return "ENVIRONMENT cell\nPROCESSOR P0" + chance_.one_of({"", " NONPREEMPTIVE"}) +
           "\nPROCESSOR P1\nDEVICE clock EVENT tick EVERY " + chance_.one_of({"20", "30", "50"}) +
           " ms\nPLACE SM1 ON P0 PRIORITY " + number(1 + chance_(2)) + "\nPLACE MC1 ON " +
           chance_.one_of({"P0", "P1"}) + " PRIORITY " + number(1 + chance_(2)) + "\nPLACE SD1 ON " +
           chance_.one_of({"P0", "P1"}) + " PRIORITY " + number(1 + chance_(3)) + "\nTIME pause : " + time() +
           "\nTIME work OF MC1 : " + time() + "\nTIME think : " + time() +
           "\nTIME work OF SD1 : " + number(1 + chance_(3)) + " ms\nEND ENVIRONMENT\n";
  }

  const std::string asked_ = "TXM( request motion from MC1 )\nWTM( motion from MC1 )\n";
  const std::string answered_ = "TXM( late to MC1 )\nWTM( done from MC1 )\n";
  Chance chance_;
};

}  // namespace pal::test
