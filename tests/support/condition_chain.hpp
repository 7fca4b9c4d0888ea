// Random cause-effect chains whose stages talk by conditions alone.
#pragma once

#include <cstdint>
#include <string>

#include "tests/support/chance.hpp"

namespace pal::test {

/// The text of a skill with its environment. Two or three modules have a clock of their own each. Each sets a
/// condition that the next one reads, by RPC or in a test, before or after its work. Some ask a device first.
/// They share few processors, with few priorities. In one skill of three the phases and the end are given, so
/// that there are few runs. All times are whole milliseconds. The same seed gives the same text.
class ConditionChain {
 public:
  explicit ConditionChain(std::uint64_t seed) : chance_(seed) {}

  std::string text() {
    const int stages = chance_.between(2, 3);
    const int processors = chance_.between(1, 2);
    const bool phases = chance_(3) == 0;
    std::string messages = "MESSAGE stop : SIGNAL\nDEVICE button\n";
    std::string drivers;
    std::string modules;
    std::string environment = "ENVIRONMENT cell\n  PROCESSOR idle\n";
    for (int p = 0; p < processors; ++p)
      environment += "  PROCESSOR P" + number(p) + (chance_(5) == 0 ? " NONPREEMPTIVE\n" : "\n");
    for (int s = 0; s < stages; ++s) {
      const std::string me = number(s);
      messages +=
          "MESSAGE tick-" + me + " : SIGNAL\nMESSAGE v-" + me + " : REAL N\nDEVICE clock-" + me + "\n";
      if (s + 1 < stages) messages += "CONDITION c-" + me + "\n";
      drivers += "SD-" + me + ", ";
      modules += stage(s, s + 1 == stages);
      if (asks_) messages += "DEVICE sensor-" + me + "\n";
      if (asks_) environment += "  DEVICE sensor-" + me + " ON REQUEST " + chance_.interval(1, 3) + "\n";
      environment += clock(me, phases);
      environment += "  PLACE SD-" + me + " ON P" + number(chance_(processors)) + " PRIORITY ";
      environment +=
          number(chance_.between(1, 3)) + "\n  TIME work OF SD-" + me + " : " + chance_.interval(0, 2) + "\n";
    }
    for (const char* cost : {"SET", "READ", "TEST", "RECEIVE"}) {
      if (chance_(5) == 0) environment += std::string("  COST ") + cost + " " + chance_.interval(0, 1) + "\n";
    }
    const std::string last = number(stages - 1);
    environment += "  TIME done OF SD-" + last + " : " + chance_.interval(0, 2) + "\n";
    const std::string at = " AT done IN SD-" + last + " AT MOST 1 s\n";
    const std::string sample = "tick-0 FROM clock-0";
    const std::string condition = "c-" + number(stages - 2);
    return messages + "SKILL conditions\n  SENSOR DRIVER " + drivers + R"(SD-stop
  LOGICAL SENSOR LS-stop
  MACHINE CONTROLLER NONE
  MODEL DATA NONE
  SKILL METHOD SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR "any other error"
  REQUIREMENT sample : AGE OF )" +
           sample + at + "  REQUIREMENT world : REACTION OF " + sample + at +
           "  REQUIREMENT value : AGE OF " + condition + at + "  REQUIREMENT change : REACTION OF " +
           condition + at + "END SKILL\n" + modules +
           R"(Sensor Driver: SD-stop
BEGIN
  WTM( stop from button )
  TXM( stop to LS-stop )
END
Logical Sensor: LS-stop
BEGIN
  WTM( stop from SD-stop )
  TXM( stop to SM1 )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( stop from LS-stop )
  TXM( Completion Protocol 0 )
END
)" + environment +
           "  DEVICE button EVENT stop " + (phases ? "EVERY 100 ms PHASE 99 ms" : "SPORADIC 1 s") +
           R"(
  PLACE SD-stop ON idle PRIORITY 3
  PLACE LS-stop ON idle PRIORITY 2
  PLACE SM1 ON idle PRIORITY 1
END ENVIRONMENT
)";
  }

 private:
  static std::string number(int n) { return std::to_string(n); }

  std::string clock(const std::string& me, bool phases) {
    const int period = chance_.between(6, 20);
    std::string out = "  DEVICE clock-" + me + " EVENT tick-" + me + " EVERY " + number(period) + " ms";
    if (phases) return out + " PHASE " + number(chance_(period)) + " ms\n";
    return out + (chance_(3) == 0 ? " JITTER 1 ms\n" : "\n");
  }

  std::string stage(int s, bool last) {
    const std::string me = number(s);
    const std::string before = s == 0 ? "" : "c-" + number(s - 1);
    asks_ = chance_(4) == 0;
    const std::string ask = asks_ ? "    TXM( request v-" + me + " from sensor-" + me + " )\n    WTM( v-" +
                                        me + " from sensor-" + me + " )\n"
                                  : "";
    const std::string work = "    work\n";
    const std::string effect = last ? "    done\n" : "    SPC( c-" + me + " )\n";
    std::string body;
    if (before.empty()) {
      body = chance_(3) == 0 ? ask + effect + work : work + ask + effect;
    } else {
      switch (chance_(3)) {
        case 0:
          body = "    RPC( " + before + " )\n" + work + ask + effect;
          break;
        case 1:
          body = ask + work + "    RPC( " + before + " )\n" + effect;
          break;
        default:
          body = ask + "    CASE\n    ( " + before + " = TRUE ):\n" + work + effect + "    ( " + before +
                 " = FALSE ):\n" + effect + "    END CASE\n";
          break;
      }
    }
    return "Sensor Driver: SD-" + me + "\n  ACTIVITY work\n" + (last ? "  ACTIVITY done\n" : "") +
           "BEGIN\n  REPEAT\n    WTM( tick-" + me + " from clock-" + me + " )\n" + body +
           "  UNTIL( forever )\nEND\n";
  }

  Chance chance_;
  bool asks_ = false;
};

}  // namespace pal::test
