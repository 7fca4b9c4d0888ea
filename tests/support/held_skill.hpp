// Random skills in which sends wait for their slots.
#pragma once

#include <cstdint>
#include <string>

#include "tests/support/chance.hpp"

namespace pal::test {

/// The text of a skill with its environment. A method takes a force, and ends each round with a motion. The
/// sensor sends the force by itself or on request, directly or by way of another module. The controller that
/// takes the motions shares its processor with a driver that now and then has much to do. All times are whole
/// milliseconds. The same seed gives the same text.
class HeldSkill {
 public:
  explicit HeldSkill(std::uint64_t seed) : chance_(seed) {}

  std::string text() {
    const bool asked = chance_(2) == 0;
    const bool relayed = chance_(2) == 0;
    sensor_ = relayed ? "SD2" : "LS1";
    sensed_ = relayed ? "raw" : "force";
    const std::string limit = " AT MOST 1 s\n";
    std::string out =
        R"(MESSAGE force : REAL N
MESSAGE raw : REAL N
MESSAGE motion : dz : REAL mm
MESSAGE correction : dz : REAL mm
MESSAGE tick : SIGNAL
DEVICE clock
DEVICE robot
SKILL held
  SENSOR DRIVER      SD1)" +
        std::string(relayed ? ", SD2" : "") + R"(
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT taken : INTERVAL OF WTM( force from LS1 ) IN SM1)" +
        limit + "  REQUIREMENT sent : INTERVAL OF TXM( motion to MC1 ) IN SM1 BETWEEN 1 ms AND 1 s\n" +
        "  REQUIREMENT obeyed : INTERVAL OF obey IN MC1" + limit + "  REQUIREMENT sample : AGE OF " +
        sensed_ + " FROM " + sensor_ + " AT obey IN MC1" + limit + "  REQUIREMENT world : REACTION OF " +
        sensed_ + " FROM " + sensor_ + " AT obey IN MC1" + limit +
        "  REQUIREMENT busy : BUSY PERIOD OF EACH PROCESSOR" + limit +
        "  REQUIREMENT follows : RESPONSE FROM motion OF SM1 TO obey IN MC1" + limit;
    if (relayed)
      out += "  REQUIREMENT decided : RESPONSE FROM force OF LS1 TO TXM( motion to MC1 )" + limit +
             "  REQUIREMENT through : RESPONSE FROM force OF LS1 TO obey IN MC1" + limit;
    if (!asked) {
      out += "  REQUIREMENT put : RESPONSE FROM " + sensed_ + " OF " + sensor_ + " TO TXM( motion to MC1 )" +
             limit + "  REQUIREMENT done : RESPONSE FROM " + sensed_ + " OF " + sensor_ + " TO obey IN MC1" +
             limit + "  REQUIREMENT lost : LOSS OF " + sensor_ + " NONE\n";
    }
    return out + "END SKILL\n" + modules(asked, relayed) + environment(asked);
  }

 private:
  static std::string number(int n) { return std::to_string(n); }
  std::string maybe(int n, const std::string& line) { return chance_(n) == 0 ? line : ""; }

  std::string modules(bool asked, bool relayed) {
    const std::string request = asked ? "    TXM( request " + sensed_ + " from " + sensor_ + " )\n" : "";
    const std::string relay = request + "  REPEAT\n    WTM( raw from SD2 )\n" + request +
                              "    TXM( force to SM1 )\n  UNTIL( forever )\nEND\n";
    const std::string sensor =
        "Logical Sensor: LS1\n" + (relayed ? "BEGIN\n" + relay + "Sensor Driver: SD2\n" : std::string());
    const std::string ask = relayed ? "" : request;
    std::string out =
        "Sensor Driver: SD1\n  ACTIVITY work\nBEGIN\n  REPEAT\n    WTM( tick from clock )\n    work\n"
        "  UNTIL( forever )\nEND\n" +
        sensor +
        "Machine Controller: MC1\n  ACTIVITY obey\n"
        "BEGIN\n  REPEAT\n    WTM( motion from SM1 )\n    obey\n";
    out += maybe(3, "    TXM( correction to robot )\n");
    out += "  UNTIL( forever )\nEND\nSkill Module: SM1\n  ACTIVITY think\nBEGIN\n  WTM( Coordinator )\n";
    out += maybe(4, "  think\n");
    out += ask + "  REPEAT\n    WTM( force from LS1 )\n";
    const std::string thinks = maybe(2, "    think\n");
    out += chance_(2) == 0 ? thinks + ask : ask + thinks;
    return out + "    TXM( motion to MC1 )\n  UNTIL( forever )\nEND\n";
  }

  std::string environment(bool asked) {
    std::string out = "ENVIRONMENT cell\n";
    out += "  PROCESSOR P1" + maybe(4, " NONPREEMPTIVE") + "\n";
    out += "  PROCESSOR P2" + maybe(4, " NONPREEMPTIVE") + "\n";
    const int period = chance_.between(4, 9);
    if (asked) {
      out += "  DEVICE " + sensor_ + " ON REQUEST " + chance_.interval(period - 1, period + 1) + "\n";
    } else {
      out += "  DEVICE " + sensor_ + " EVENT " + sensed_ + " EVERY " + number(period) + " ms";
      out += maybe(2, " JITTER " + number(chance_.between(1, 3)) + " ms") + "\n";
    }
    out += "  DEVICE clock EVENT tick EVERY " + number(chance_.between(30, 60)) + " ms";
    out += maybe(3, " JITTER 2 ms") + "\n";
    out += maybe(5, "  LATENCY BETWEEN PROCESSORS " + chance_.interval(0, 1) + "\n");
    out += maybe(5, "  COST RECEIVE " + chance_.interval(0, 1) + "\n");
    out += "  PLACE SM1 ON P" + number(chance_(4) == 0 ? 2 : 1) + " PRIORITY " +
           number(chance_.between(1, 3)) + "\n";
    if (sensor_ == "SD2") out += "  PLACE LS1 ON P1 PRIORITY " + number(chance_.between(1, 3)) + "\n";
    out += "  PLACE MC1 ON P2 PRIORITY " + number(chance_.between(1, 2)) + "\n";
    out += "  PLACE SD1 ON P" + number(chance_(6) == 0 ? 1 : 2) + " PRIORITY " +
           number(chance_.between(2, 3)) + "\n";
    out += "  TIME think : " + chance_.interval(0, 1) + "\n  TIME obey : " + chance_.interval(0, 2) + "\n";
    return out + "  TIME work : " + chance_.interval(period - 2, 2 * period) + "\nEND ENVIRONMENT\n";
  }

  Chance chance_;
  std::string sensor_;  // the device
  std::string sensed_;
};

}  // namespace pal::test
