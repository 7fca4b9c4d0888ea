// Random skills that keep pace, so that there is something to say about each measure.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/chance.hpp"
#include "tests/support/executed_blocks.hpp"

namespace pal::test {

/// The text of a skill with its environment:
/// - a robot that asks for motions at a steady pace;
/// - a sensor that is asked, runs in frames or sends by itself, with or without a courier;
/// - a skill method in one of several shapes: one round, two loops at a time of which one may end, blocks
///   within each round, blocks at the start, or straight to the completion.
///
/// All times are whole milliseconds. The same seed gives the same text.
class TimedSkill {
 public:
  explicit TimedSkill(std::uint64_t seed) : chance_(seed), executed_(seed, 4) {}

  std::string text() {
    shape_ = static_cast<Shape>(chance_(7));
    sensor_ = static_cast<Sensor>(chance_(3));
    driver_module_ = sensor_ == Sensor::sends || chance_(2) == 0;
    robot_module_ = chance_(3) != 0 || straight();
    // A sensor that sends by itself is taken by a loop of its own.
    if (sensor_ == Sensor::sends && shape_ != Shape::loops && shape_ != Shape::endless_loops)
      sensor_ = Sensor::asked;
    const std::string limit = std::to_string(chance_.between(4, 120)) + " ms";
    // In the order of drawing: the operands of + have none.
    std::string out = messages() + "SKILL timed\n" + R"(  SENSOR DRIVER      SD1
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
)" + executed_.contingency();
    out += requirements(limit);
    out += "END SKILL\n" + driver() + logical_sensor();
    out += controller();
    out += executed_.executed_in(method());
    out += executed_.module("pc-force");
    return out + environment();
  }

 private:
  enum class Shape {
    round,
    loops,
    endless_loops,
    blocks_in_round,
    blocks_at_start,
    straight,
    straight_blocks
  };
  enum class Sensor { asked, frames, sends };

  bool straight() const { return shape_ == Shape::straight || shape_ == Shape::straight_blocks; }

  static std::string messages() {
    return R"(MESSAGE force : REAL N
MESSAGE raw : REAL N
MESSAGE motion : dz : REAL mm
MESSAGE correction : dz : REAL mm
MESSAGE tick : SIGNAL
CONDITION pc-force FROM force "touching"
CONDITION pc-stop             "far enough"
DEVICE sensor "raw forces"
DEVICE robot "asks for corrections"
)";
  }

  std::string requirements(const std::string& limit) {
    const std::string sensor = driver_module_ ? "sensor" : "SD1";
    const std::string robot = robot_module_ ? "robot" : "MC1";
    const std::string at = straight() ? "think IN SM1" : "TXM( motion to MC1 ) IN SM1";
    const std::string most = " AT MOST " + limit;
    std::string all[] = {
        "AGE OF pc-force AT " + at + most,
        "AGE OF raw FROM " + sensor + " AT " + at + most,
        "REACTION OF pc-force AT " + at + most,
        "REACTION OF raw FROM " + sensor + " AT " + at + most,
        "INTERVAL OF " + at + most,
        "INTERVAL OF " + at + " AT LEAST " + std::to_string(chance_.between(1, 40)) + " ms",
        "INTERVAL OF WTM( raw from SD1 ) IN LS1 BETWEEN 2 ms AND " + limit,
        "BUSY PERIOD OF EACH PROCESSOR" + most,
        straight() ? "DURATION TO COMPLETION 0" + most : "LOSS OF " + robot + " NONE",
        straight()      ? "LOSS OF " + sensor + " AT MOST 1 IN 3"
        : robot_module_ ? "RESPONSE FROM tick OF robot TO TXM( correction to robot )" + most
                        : "RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 )" + most,
    };
    std::string out;
    int number = 0;
    if (shape_ == Shape::blocks_in_round) {
      out += "  REQUIREMENT block-1 : INTERVAL OF think IN SM1" + most + "\n";
      out += "  REQUIREMENT block-2 : REACTION OF raw FROM " + sensor + " AT SPC( pc-force ) IN SM1" + most +
             "\n";
      out += "  REQUIREMENT block-3 : INTERVAL OF SPC( pc-force ) IN SM1 AT LEAST 9 ms\n";
    }
    if (shape_ == Shape::loops) out += "  REQUIREMENT after : AGE OF pc-force AT think IN SM1" + most + "\n";
    for (const std::string& each : messages_answered(at + most, most))
      out += "  REQUIREMENT m-" + std::to_string(++number) + " : " + each + "\n";
    for (const std::string& each : all)
      out += "  REQUIREMENT r-" + std::to_string(++number) + " : " + each + "\n";
    return out;
  }

  /// Responses to what modules, and devices that are asked, send.
  std::vector<std::string> messages_answered(const std::string& at, const std::string& most) const {
    std::vector<std::string> all = {"RESPONSE FROM force OF LS1 TO " + at,
                                    "RESPONSE FROM raw OF SD1 TO TXM( force to SM1 )" + most};
    if (sensor_ != Sensor::sends) {
      all.push_back("RESPONSE FROM request force OF SM1 TO TXM( force to SM1 )" + most);
      all.push_back("RESPONSE FROM request force OF SM1 TO SPC( pc-force ) IN SM1" + most);
    }
    if (robot_module_ && !straight()) {
      all.push_back("RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 )" + most);
      all.push_back("RESPONSE FROM motion OF SM1 TO TXM( correction to robot )" + most);
    }
    return all;
  }

  std::string driver() const {
    if (!driver_module_) return "Sensor Driver: SD1\n";
    if (sensor_ == Sensor::sends) {
      return "Sensor Driver: SD1\nBEGIN\n  REPEAT\n    WTM( raw from sensor )\n    TXM( raw to LS1 )\n"
             "  UNTIL( forever )\nEND\n";
    }
    return "Sensor Driver: SD1\nBEGIN\n  REPEAT\n    WTM( request raw from LS1 )\n"
           "    TXM( request raw from sensor )\n    WTM( raw from sensor )\n    TXM( raw to LS1 )\n"
           "  UNTIL( forever )\nEND\n";
  }

  std::string logical_sensor() const {
    std::string out = "Logical Sensor: LS1\n  ACTIVITY extract READS raw WRITES force\nBEGIN\n  REPEAT\n";
    if (sensor_ != Sensor::sends)
      out += "    WTM( request force from SM1 )\n    TXM( request raw from SD1 )\n";
    return out + "    WTM( raw from SD1 )\n    extract\n    TXM( force to SM1 )\n  UNTIL( forever )\nEND\n";
  }

  std::string controller() {
    if (!robot_module_) return "Machine Controller: MC1\n";
    std::string out = "Machine Controller: MC1\n  ACTIVITY hold WRITES correction\n";
    if (straight())
      return out +
             "BEGIN\n  REPEAT\n    WTM( tick from robot )\n    hold\n    TXM( correction to robot )\n"
             "  UNTIL( forever )\nEND\n";
    out +=
        "  ACTIVITY obey READS motion WRITES correction\nBEGIN\n  REPEAT\n    WTM( tick from robot )\n    "
        "TXM( request motion from SM1 )\n";
    if (chance_(5) == 0) {
      out += "    WTM( motion from SM1 ) WITHIN " + std::to_string(chance_.between(4, 15)) +
             " ms\n      obey\n    ELSE\n      hold\n    END WTM\n";
    } else {
      out += "    WTM( motion from SM1 )\n    obey\n";
    }
    return out + "    TXM( correction to robot )\n  UNTIL( forever )\nEND\n";
  }

  std::string sense() { return sensed() + executed_.call(); }
  std::string sensed() {
    if (sensor_ == Sensor::sends) return "      WTM( force from LS1 )\n      SPC( pc-force )\n";
    std::string out = "      TXM( request force from LS1 )\n";
    if (chance_(4) == 0) out += "      prepare\n";
    return out + "      WTM( force from LS1 )\n      SPC( pc-force )\n";
  }

  std::string decide() { return executed_.call() + decided(); }
  std::string decided() {
    if (chance_(2) == 0) {
      return "      CASE\n        ( pc-force = TRUE ):\n          TXM( motion to MC1 )\n"
             "        ( pc-force = FALSE ):\n          think\n          TXM( motion to MC1 )\n      END "
             "CASE\n";
    }
    return std::string(chance_(2) == 0 ? "      RPC( pc-force )\n      think\n" : "      RPC( pc-force )\n") +
           "      TXM( motion to MC1 )\n";
  }

  std::string wait() { return "      WTM( motion request from MC1 )\n"; }

  std::string method() {
    std::string out =
        "Skill Module: SM1\n  ACTIVITY think\n  ACTIVITY prepare\nBEGIN\n  WTM( Coordinator )\n";
    const std::string complete = "  TXM( Completion Protocol 0 )\nEND\n";
    const std::string blocks = "    CONCURRENT\n    BEGIN\n";
    const std::string beside = "    END\n    BEGIN\n";
    const std::string joined = "    END\n    END CONCURRENT\n";
    switch (shape_) {
      case Shape::round:
        if (chance_(3) == 0) out += sense();
        return out + "  REPEAT\n" + wait() + sense() + decide() +
               (chance_(2) == 0 ? "      SPC( pc-stop )\n  UNTIL( pc-stop )\n" + complete
                                : "  UNTIL( forever )\nEND\n");
      case Shape::loops:
      case Shape::endless_loops: {
        const bool ends = shape_ == Shape::loops;
        if (chance_(3) == 0 && sensor_ != Sensor::sends) out += sense();
        return out + blocks + "    REPEAT\n" + sense() + "    UNTIL( forever )\n" + beside + "    REPEAT\n" +
               (chance_(2) == 0 ? wait() + decide() : decide_later()) +
               (ends ? "      SPC( pc-stop )\n    UNTIL( pc-stop )\n" : "    UNTIL( forever )\n") +
               (ends && chance_(4) == 0 ? beside + "      think\n" : "") + joined +
               (ends ? std::string(chance_(3) == 0 ? "      RPC( pc-force )\n" : "") + "  think\n" + complete
                     : "END\n");
      }
      case Shape::blocks_in_round:
        return out + "  REPEAT\n" + wait() + blocks + sense() + beside + "      think\n" +
               (chance_(3) == 0 ? beside + "      prepare\n" : "") + joined + decide() +
               "  UNTIL( forever )\nEND\n";
      case Shape::blocks_at_start:
        return out + blocks + sense() + beside + "      prepare\n" + joined + "  REPEAT\n" + wait() +
               (chance_(2) == 0 ? sense() : "") + decide() + "  UNTIL( forever )\nEND\n";
      case Shape::straight:
        out += sense() + "      RPC( pc-force )\n      think\n";
        if (chance_(2) == 0) out += sense() + "      RPC( pc-force )\n      think\n";
        return out + complete;
      case Shape::straight_blocks:
        return out + blocks + sense() + beside + "      prepare\n" +
               (chance_(2) == 0 ? beside + "      prepare\n" : "") + joined +
               "      RPC( pc-force )\n      think\n" +
               (chance_(2) == 0 ? sense() + "      RPC( pc-force )\n      think\n" : "") + complete;
    }
    return out;
  }

  /// The value is read before the wait, and old when it is used.
  std::string decide_later() {
    return "      RPC( pc-force )\n" + wait() +
           "      CASE\n        ( pc-force = TRUE ):\n          TXM( motion to MC1 )\n"
           "        ( pc-force = FALSE ):\n          TXM( motion to MC1 )\n      END CASE\n";
  }

  std::string place(const std::string& thread, int processors) {
    return "  PLACE " + thread + " ON P" + std::to_string(chance_(processors)) + " PRIORITY " +
           std::to_string(chance_.between(1, 4)) + "\n";
  }

  std::string environment() {
    std::string out = "ENVIRONMENT cell\n";
    const int processors = chance_.between(1, 3);
    for (int p = 0; p < processors; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance_(4) == 0 ? " NONPREEMPTIVE\n" : "\n");
    const std::string sensor = driver_module_ ? "sensor" : "SD1";
    if (sensor_ == Sensor::sends) {
      out += "  DEVICE sensor EVENT raw EVERY " + std::to_string(chance_.between(8, 30)) + " ms" +
             (chance_(4) == 0 ? " JITTER 1 ms\n" : "\n");
    } else if (sensor_ == Sensor::frames) {
      const int frame = chance_.between(3, 9);
      out += "  DEVICE " + sensor + " FRAMES EVERY " + std::to_string(frame) + " ms COLLECTING " +
             std::to_string(chance_.between(1, frame)) + " ms\n";
    } else {
      out += "  DEVICE " + sensor + " ON REQUEST " + chance_.interval(1, 6) + "\n";
    }
    const std::string robot = robot_module_ ? "robot EVENT tick" : "MC1 EVENT motion request";
    out += "  DEVICE " + robot + (chance_(9) == 0 ? " SPORADIC " : " EVERY ") +
           std::to_string(chance_.between(18, 60)) + " ms" + (chance_(4) == 0 ? " JITTER 1 ms\n" : "\n");
    out += place("SM1", processors) + place("LS1", processors);
    if (shape_ == Shape::loops || shape_ == Shape::endless_loops) {
      if (chance_(2) == 0) out += place("SM1.1", processors);
      if (chance_(2) == 0) out += place("SM1.2", processors);
    }
    out += executed_.times_and_places(processors);
    if (driver_module_) out += place("SD1", processors);
    if (robot_module_) out += place("MC1", processors);
    for (const char* activity : {"extract", "think", "prepare", "obey", "hold"})
      out += std::string("  TIME ") + activity + " : " + chance_.interval(0, 2) + "\n";
    for (const char* cost : {"SEND", "RECEIVE", "SET", "READ", "TEST"}) {
      if (chance_(6) == 0) out += std::string("  COST ") + cost + " " + chance_.interval(0, 1) + "\n";
    }
    if (chance_(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + chance_.interval(0, 1) + "\n";
    if (chance_(2) == 0) out += "  LATENCY BETWEEN PROCESSORS " + chance_.interval(0, 1) + "\n";
    return out + "END ENVIRONMENT\n";
  }

  Chance chance_;
  ExecutedBlocks executed_;
  Shape shape_ = Shape::round;
  Sensor sensor_ = Sensor::asked;
  bool driver_module_ = true;
  bool robot_module_ = true;
};

}  // namespace pal::test
