// Small random skills, for properties that must hold of all of them.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "tests/support/chance.hpp"
#include "tests/support/executed_blocks.hpp"

namespace pal::test {

/// The text of a skill with its environment: a sensor that is asked, a robot that asks, and a skill between
/// them, in many shapes. All times are whole milliseconds, none above `longest`. The same seed gives the same
/// text.
class RandomSkill {
 public:
  RandomSkill(std::uint64_t seed, int longest)
      : chance_(seed), required_(seed), executed_(seed, 4), longest_(longest) {}

  std::string text() {
    const bool sensor_module = chance_(2);
    const bool controller_module = chance_(3) != 0;
    const bool concurrent = chance_(3) != 0;
    std::string out = R"(
MESSAGE force : REAL N
MESSAGE raw : REAL N
MESSAGE motion : dz : REAL mm
MESSAGE correction : dz : REAL mm
MESSAGE tick : SIGNAL
CONDITION pc-force FROM force "touching"
CONDITION pc-stop             "far enough"
DEVICE sensor "asked for raw forces"
DEVICE robot "asks for corrections"
SKILL random
  SENSOR DRIVER      SD1
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "touching"
  COMPLETION 1 ERROR  "any other error"
)" + executed_.contingency() +
                      R"(  REQUIREMENT age  : AGE OF pc-force AT TXM( motion to MC1 ) IN SM1 AT MOST )" +
                      std::to_string(2 * longest_) + R"( ms
  REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 60 %
)";
    out +=
        controller_module
            ? "  REQUIREMENT answer : RESPONSE FROM tick OF robot TO TXM( correction to robot ) AT MOST " +
                  std::to_string(2 * longest_) + " ms\n"
            : "  REQUIREMENT answer : RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 ) AT MOST " +
                  std::to_string(2 * longest_) + " ms\n";
    out += requirements(sensor_module ? "sensor" : "SD1", controller_module ? "robot" : "MC1");
    out += "END SKILL\n";
    out += "Sensor Driver: SD1\n";
    if (sensor_module) {
      out += std::string(
                 "BEGIN\n  REPEAT\n    WTM( request raw from LS1 )\n    TXM( request raw from sensor )\n") +
             "    WTM( raw from sensor )\n    TXM( raw to LS1 )\n  UNTIL( forever )\nEND\n";
    }
    out += std::string("Logical Sensor: LS1\n  ACTIVITY extract READS raw WRITES force\nBEGIN\n  REPEAT\n") +
           "    WTM( request force from SM1 )\n    TXM( request raw from SD1 )\n    WTM( raw from SD1 )\n    "
           "extract\n" +
           "    TXM( force to SM1 )\n  UNTIL( forever )\nEND\n";
    out += "Machine Controller: MC1\n";
    if (controller_module) out += controller();
    std::string method =
        "Skill Module: SM1\n  ACTIVITY think\n  ACTIVITY prepare\nBEGIN\n  WTM( Coordinator )\n";
    method += sense();
    if (concurrent) {
      method += "  CONCURRENT\n  BEGIN\n    REPEAT\n" + sense() +
                "    UNTIL( forever )\n  END\n  BEGIN\n    REPEAT\n" + act() +
                "    UNTIL( pc-stop )\n  END\n" +
                (chance_(4) == 0 ? "  BEGIN\n    think\n    prepare\n  END\n" : "") + "  END CONCURRENT\n";
    } else {
      method += "  REPEAT\n" + (chance_(2) != 0 ? sense() + act() : act() + sense()) + "  UNTIL( pc-stop )\n";
    }
    out += executed_.executed_in(method + "  TXM( Completion Protocol 0 )\nEND\n");
    out += executed_.module("pc-force");
    out += environment(sensor_module, controller_module, concurrent);
    return out;
  }

 private:
  /// Some requirements of the other measures; drawn apart, so that the skill is the same without them.
  std::string requirements(const std::string& sensor, const std::string& robot) {
    const std::string at = " AT TXM( motion to MC1 ) IN SM1 AT MOST " + std::to_string(3 * longest_) + " ms";
    const std::string most = " AT MOST " + std::to_string(2 * longest_) + " ms";
    const std::string all[] = {
        "REACTION OF pc-force" + at,
        "REACTION OF raw FROM " + sensor + at,
        "AGE OF raw FROM " + sensor + at,
        "INTERVAL OF TXM( motion to MC1 ) IN SM1" + most,
        "INTERVAL OF TXM( motion to MC1 ) IN SM1 AT LEAST 2 ms",
        "INTERVAL OF WTM( raw from SD1 ) IN LS1 BETWEEN 1 ms AND " + std::to_string(longest_) + " ms",
        "LOSS OF " + sensor + " NONE",
        "LOSS OF " + robot + " AT MOST 1 IN 3",
        "DURATION TO COMPLETION 0" + most,
        "DURATION TO COMPLETION 1" + most,
        "BUSY PERIOD OF EACH PROCESSOR" + most,
        "RESPONSE FROM force OF LS1 TO TXM( motion to MC1 )" + most,
        "RESPONSE FROM request force OF SM1 TO TXM( force to SM1 )" + most,
        "RESPONSE FROM request raw OF LS1 TO SPC( pc-force ) IN SM1" + most,
        "RESPONSE FROM raw OF SD1 TO extract IN LS1" + most,
        "RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 )" + most,
        "RESPONSE FROM motion OF SM1 TO TXM( correction to robot )" + most,
    };
    std::string out;
    int number = 0;
    for (const std::string& each : all) {
      if (robot == "MC1" && each.find("correction") != std::string::npos) continue;
      if (required_() % 4 == 0) out += "  REQUIREMENT more-" + std::to_string(++number) + " : " + each + "\n";
    }
    return out;
  }

  std::string sense() { return sensed() + executed_.call(); }
  std::string sensed() {
    std::string out = "      TXM( request force from LS1 )\n";
    if (chance_(3) == 0) out += "      prepare\n";
    if (chance_(6) == 0) {
      const std::string limit =
          chance_(2) != 0 ? "" : " WITHIN " + std::to_string(chance_.between(0, longest_)) + " ms";
      return out + "      WTM FIRST" + limit + "\n        ( force from LS1 ):\n          SPC( pc-force )\n" +
             "        ( motion request from MC1 ):\n          TXM( motion to MC1 )\n          WTM( force "
             "from LS1 )\n" +
             "          SPC( pc-force )\n" + (limit.empty() ? "" : "      ELSE\n        prepare\n") +
             "      END WTM\n";
    }
    if (chance_(3) == 0) {
      return out + "      WTM( force from LS1 ) WITHIN " + std::to_string(chance_.between(0, longest_)) +
             " ms\n        SPC( pc-force )\n      ELSE\n        prepare\n      END WTM\n";
    }
    return out + "      WTM( force from LS1 )\n      SPC( pc-force )\n";
  }

  std::string act() { return executed_.call() + acted(); }
  std::string acted() {
    std::string out;
    const int order = chance_(3);
    if (order == 0) out += "      RPC( pc-force )\n";
    if (chance_(4) == 0) out += "      think\n";
    out += "      WTM( motion request from MC1 )\n";
    if (order == 1) out += "      RPC( pc-force )\n";
    if (chance_(2) == 0) {
      out +=
          std::string("      CASE\n        ( pc-force = TRUE ):\n          TXM( motion to MC1 )\n") +
          "        ( pc-force = FALSE ):\n          think\n          TXM( motion to MC1 )\n      END CASE\n";
    } else {
      if (order == 2) out += "      RPC( pc-force )\n";
      out += "      think\n      TXM( motion to MC1 )\n";
    }
    return out + "      SPC( pc-stop )\n";
  }

  std::string controller() {
    std::string out =
        "  ACTIVITY obey READS motion WRITES correction\n  ACTIVITY hold WRITES correction\nBEGIN\n  "
        "REPEAT\n";
    out += "    WTM( tick from robot )\n    TXM( request motion from SM1 )\n";
    if (chance_(2) == 0) {
      out += "    WTM( motion from SM1 ) WITHIN " + std::to_string(chance_.between(0, longest_)) +
             " ms\n      obey\n    ELSE\n      hold\n    END WTM\n";
    } else {
      out += "    WTM( motion from SM1 )\n    obey\n";
    }
    return out + "    TXM( correction to robot )\n  UNTIL( forever )\nEND\n";
  }

  std::string place(const std::string& thread, int processors) {
    return "  PLACE " + thread + " ON P" + std::to_string(chance_(processors)) + " PRIORITY " +
           std::to_string(chance_.between(1, 3)) + "\n";
  }

  std::string environment(bool sensor_module, bool controller_module, bool concurrent) {
    std::string out = "ENVIRONMENT cell\n";
    const int processors = chance_.between(1, 3);
    for (int p = 0; p < processors; ++p) {
      out += "  PROCESSOR P" + std::to_string(p) + (chance_(4) == 0 ? " NONPREEMPTIVE\n" : "\n");
    }
    const std::string sensor = sensor_module ? "sensor" : "SD1";
    const int frame = chance_.between(2, longest_);
    if (chance_(3) == 0) {
      out += "  DEVICE " + sensor + " FRAMES EVERY " + std::to_string(frame) + " ms COLLECTING " +
             std::to_string(chance_.between(1, frame)) + " ms" +
             (chance_(3) == 0 ? " PHASE " + std::to_string(chance_.between(0, frame)) + " ms\n" : "\n");
    } else {
      out += "  DEVICE " + sensor + " ON REQUEST " + chance_.interval(0, longest_ / 2) + "\n";
    }
    const std::string robot = controller_module ? "robot EVENT tick" : "MC1 EVENT motion request";
    const int period = chance_.between(longest_ / 2 + 1, longest_);
    out += "  DEVICE " + robot + (chance_(6) == 0 ? " SPORADIC " : " EVERY ") + std::to_string(period) +
           " ms" + (chance_(5) == 0 ? " JITTER 1 ms" : "") +
           (chance_(5) == 0 ? " PHASE " + std::to_string(chance_.between(0, period)) + " ms\n" : "\n");
    out += place("SM1", processors) + place("LS1", processors);
    if (concurrent && chance_(2) == 0) out += place("SM1.1", processors);
    if (concurrent && chance_(2) == 0) out += place("SM1.2", processors);
    out += executed_.times_and_places(processors);
    if (sensor_module) out += place("SD1", processors);
    if (controller_module) out += place("MC1", processors);
    for (const char* activity : {"extract", "think", "prepare", "obey", "hold"}) {
      out += std::string("  TIME ") + activity + " : " + chance_.interval(0, 2) + "\n";
    }
    for (const char* cost : {"SEND", "RECEIVE", "SET", "READ", "TEST"}) {
      if (chance_(4) == 0) out += std::string("  COST ") + cost + " " + chance_.interval(0, 1) + "\n";
    }
    if (chance_(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + chance_.interval(0, 1) + "\n";
    if (chance_(2) == 0) out += "  LATENCY BETWEEN PROCESSORS " + chance_.interval(0, 1) + "\n";
    return out + "END ENVIRONMENT\n";
  }

  Chance chance_;
  std::mt19937_64 required_;
  ExecutedBlocks executed_;
  int longest_;
};

}  // namespace pal::test
