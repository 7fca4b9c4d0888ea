// Small random skills whose modules talk in any order, so that many of them get stuck.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// The text of a skill with one or two sensors, a controller and a method. The same seed gives the same text.
class RandomTalk {
 public:
  explicit RandomTalk(std::uint64_t seed) : chance_(seed), ahead_(seed), executed_(~seed) {}

  std::string text() {
    const bool driver = chance_(3) == 0;
    two_ = chance_(3) == 0;
    std::string out = R"(DEVICE robot
MESSAGE force : SIGNAL
MESSAGE place : SIGNAL
MESSAGE raw : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
CONDITION d
CONDITION e
SKILL s
)";
    if (driver) out += "  SENSOR DRIVER SD1\n";
    out += std::string("  LOGICAL SENSOR LS1") + (two_ ? ", LS2" : "") + R"(
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  CONTINGENCY 1 "lost" METHOD CM1
  COMPLETION 0 NORMAL
  COMPLETION 1 CONTINGENCY 1
  COMPLETION 2 ERROR
END SKILL
)";
    if (driver) {
      out +=
          "DEVICE probe\nSensor Driver: SD1\nBEGIN\n  REPEAT\n    WTM( request raw from LS1 )\n    TXM( "
          "request raw from probe "
          ")\n    WTM( raw from probe )\n    TXM( raw to LS1 )\n  UNTIL( forever )\nEND\n";
    }
    out += "Logical Sensor: LS1\nBEGIN\n  REPEAT\n";
    if (driver) {
      out += talk({"WTM( request force from SM1 )", "TXM( request raw from SD1 )", "WTM( raw from SD1 )",
                   "TXM( force to SM1 )"});
    } else {
      out += talk({"WTM( request force from SM1 )", "TXM( force to SM1 )"});
    }
    out += "  UNTIL( forever )\nEND\n";
    if (two_) {
      out += "Logical Sensor: LS2\nBEGIN\n  REPEAT\n";
      out += talk({"WTM( request place from SM1 )", "TXM( place to SM1 )"}) + "  UNTIL( forever )\nEND\n";
    }
    out += "Machine Controller: MC1\nBEGIN\n  REPEAT\n";
    if (chance_(2) != 0) out += "    WTM( tick from robot )\n";
    out += talk({"TXM( request motion from SM1 )", waits("motion", "SM1")});
    blocks_ = executed_() % 3 == 0;
    out += "  UNTIL( forever )\nEND\nContingency Module: CM1\nBEGIN\n" +
           executed(talk({"WTM( request motion from MC1 )", "TXM( motion to MC1 )"})) + "END\n";
    out += "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n  SPC( c )\n  SPC( d )\n  SPC( e = FALSE )\n";
    const std::uint64_t ahead = ahead_() % 6;  // drawn apart, so that the skill is the same without
    if (ahead < 2) out += "  TXM( request force from LS1 )\n";
    switch (chance_(5)) {
      case 0:
        out += "  REPEAT\n" + sense() + (two_ ? locate() : "") + act() + "  UNTIL( c OR d )\n";
        break;
      case 1:
        out += "  CONCURRENT\n" + block("  REPEAT\n" + inner() + "  UNTIL( forever )\n") +
               block(looped(act(), "d")) + "  END CONCURRENT\n";
        break;
      default:
        out += "  CONCURRENT\n" + block(looped(sense(), chance_(2) != 0 ? "forever" : "d")) +
               (two_ ? block(looped(locate(), chance_(2) != 0 ? "forever" : "e")) : "") +
               (ahead_() % 8 == 0 ? block(looped(sense(), "forever")) : "") + block(looped(act(), "d")) +
               "  END CONCURRENT\n";
    }
    if (ahead == 1 || ahead == 2) out += "  WTM( force from LS1 )\n";
    if (chance_(2) != 0) {
      out += std::string(chance_(3) == 0 ? "  RPC( c )\n" : "") +
             "  CASE\n    ( c = TRUE ): Execute CM1\n    ( c = FALSE ):\n" + (chance_(2) == 0 ? act() : "") +
             "  END CASE\n";
    } else {
      out += "  CASE\n    ( e = TRUE ): Execute CM1\n    ( e = FALSE ): Do Nothing\n  END CASE\n";
    }
    return out + "  TXM( Completion Protocol 0 )\nEND\n";
  }

 private:
  static std::string block(const std::string& body) { return "  BEGIN\n" + body + "  END\n"; }
  static std::string looped(const std::string& body, const std::string& until) {
    return "  REPEAT\n" + body + "  UNTIL( " + until + " )\n";
  }

  /// The body of the contingency module: perhaps with a CONCURRENT, and then blocks execute it too.
  std::string executed(const std::string& body) {
    if (!blocks_) return body;
    switch (executed_() % 4) {
      case 0:
        return "  CONCURRENT\n" + block(body) + block("    RPC( c )\n") + "  END CONCURRENT\n";
      case 1:
        return "  CONCURRENT\n" + block("    WTM( request motion from MC1 )\n") +
               block("    TXM( motion to MC1 )\n") + "  END CONCURRENT\n";
      case 2:
        return "  CONCURRENT\n" + block(body) + block(looped("    TXM( motion to MC1 )\n", "forever")) +
               "  END CONCURRENT\n";
      default:
        return "  CONCURRENT\n" + block(body) +
               block("    CONCURRENT\n" + block("    TXM( motion to MC1 )\n") + block("    Do Nothing\n") +
                     "    END CONCURRENT\n") +
               "  END CONCURRENT\n";
    }
  }
  std::string call() { return blocks_ && executed_() % 3 == 0 ? "    Execute CM1\n" : ""; }

  std::string sense() { return sensed() + call(); }
  std::string act() { return call() + acted(); }

  std::string sensed() { return talk({"TXM( request force from LS1 )", waits("force", "LS1"), "SPC( c )"}); }
  std::string locate() { return talk({"TXM( request place from LS2 )", waits("place", "LS2"), "SPC( e )"}); }
  std::string acted() {
    if (chance_(5) == 0) {
      return "    RPC( c )\n    WTM( request motion from MC1 )\n    CASE\n    ( c = TRUE ): SPC( d = TRUE "
             ")\n    ( NOT c ): SPC( d "
             ")\n    END CASE\n    TXM( motion to MC1 )\n";
    }
    return talk({"WTM( request motion from MC1 )", "TXM( motion to MC1 )", "SPC( d )"});
  }
  /// What a block that goes on for ever does each time.
  std::string inner() {
    if (chance_(3) == 0) {
      const bool within = chance_(2) != 0;
      return "    TXM( request force from LS1 )\n    WTM FIRST" + std::string(within ? " WITHIN 1 ms" : "") +
             "\n      ( force from LS1 ): SPC( c )\n" + (two_ ? "      ( place from LS2 ): SPC( e )\n" : "") +
             (within ? "    ELSE\n      Do Nothing\n" : "") + "    END WTM\n" +
             (two_ ? "    TXM( request place from LS2 )\n" : "");
    }
    return "    CONCURRENT\n" + block(sense()) +
           block(two_ ? looped(locate(), chance_(2) != 0 ? "forever" : "e") : "Do Nothing\n") +
           "    END CONCURRENT\n";
  }

  std::string waits(const std::string& message, const std::string& from) {
    const auto wait = "WTM( " + message + " from " + from + " )";
    return chance_(3) != 0 ? wait
                           : wait + " WITHIN 1 ms\n      Do Nothing\n    ELSE\n      Do Nothing\n    END WTM";
  }

  /// The statements, mostly in order; now and then two change places, or one comes twice.
  std::string talk(std::vector<std::string> statements) {
    const auto pick = [&] { return static_cast<std::size_t>(chance_(static_cast<int>(statements.size()))); };
    if (chance_(4) == 0) std::swap(statements[pick()], statements[pick()]);
    if (chance_(6) == 0) statements.push_back(statements[static_cast<std::size_t>(chance_(2))]);
    std::string out;
    for (const auto& statement : statements) out += "    " + statement + "\n";
    return out;
  }

  Chance chance_;
  std::mt19937_64 ahead_;
  std::mt19937_64 executed_;
  bool two_ = false;
  bool blocks_ = false;
};

/// The text of a skill whose method asks one or two sensors a few times and mostly gives up. The sensors do
/// not answer every request once. So a limited number of requests are withdrawn and not yet answered.
class RandomPolling {
 public:
  explicit RandomPolling(std::uint64_t seed) : chance_(seed) {}

  std::string text() {
    const bool blocks = chance_(3) == 0;
    std::string out =
        "MESSAGE force : SIGNAL\nMESSAGE place : SIGNAL\nCONDITION c\nSKILL s\n  LOGICAL SENSOR LS1, LS2\n"
        "  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n  COMPLETION 2 ERROR\nEND SKILL\n";
    out += sensor("LS1", "force") + sensor("LS2", "place");
    out += "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n";
    const auto polls = [&] {
      std::string some;
      for (int i = 2 + chance_(3); i > 0; --i)
        some += chance_(4) == 0 ? poll("LS2", "place") : poll("LS1", "force");
      return some;
    };
    if (blocks) {
      out += "  CONCURRENT\n  BEGIN\n  REPEAT\n" + ask("LS2", "place") + "  WTM( place from LS2 )\n" +
             "  UNTIL( forever )\n  END\n  BEGIN\n" + polls() + "  END\n  END CONCURRENT\n";
    } else {
      out += polls() + poll("LS2", "place");
    }
    return out + "  TXM( Completion Protocol 0 )\nEND\n";
  }

 private:
  std::string sensor(const std::string& name, const std::string& message) {
    const std::string take = "    WTM( request " + message + " from SM1 )\n";
    const std::string give = "    TXM( " + message + " to SM1 )\n";
    static const std::vector<std::string> orders = {"wt", "wt", "wwt", "wwtt", "wtwwt", "wwwt", "wwtwt"};
    std::string body;
    for (const char step : orders[static_cast<std::size_t>(chance_(7))]) body += step == 'w' ? take : give;
    return "Logical Sensor: " + name + "\nBEGIN\n  REPEAT\n" + body + "  UNTIL( forever )\nEND\n";
  }

  static std::string ask(const std::string& sensor, const std::string& message) {
    return "  TXM( request " + message + " from " + sensor + " )\n";
  }

  std::string poll(const std::string& sensor, const std::string& message) {
    const auto wait = "  WTM( " + message + " from " + sensor + " )";
    const bool gives_up = chance_(4) != 0;
    const std::string then = chance_(3) == 0 ? "    SPC( c )\n" : "    Do Nothing\n";
    return ask(sensor, message) + wait +
           (gives_up ? " WITHIN 1 ms\n" + then + "  ELSE\n    Do Nothing\n  END WTM\n" : "\n");
  }

  Chance chance_;
};

/// The text of a skill whose method asks two or three sensors from blocks within blocks. Some blocks end and
/// cancel others again and again. The method tests the conditions that they set. Some sensors answer only if
/// a condition allows it.
class RandomNest {
 public:
  explicit RandomNest(std::uint64_t seed) : chance_(seed) {}

  std::string text() {
    sensors_ = 2 + (chance_(3) == 0 ? 1 : 0);
    const bool mover = chance_(2) == 0;
    gate_ = chance_(3) == 0;
    std::string out = "CONDITION reached\nCONDITION lost\n";
    driver_ = gate_ && chance_(2) == 0;
    if (gate_) out += "CONDITION gate\n";
    if (driver_) out += "MESSAGE raw : SIGNAL\n";
    std::string names;
    for (int i = 1; i <= sensors_; ++i) {
      const auto n = std::to_string(i);
      out += "MESSAGE value" + n + " : SIGNAL\nCONDITION c" + n + "\n";
      names += (i == 1 ? "LS" : ", LS") + n;
    }
    if (mover) out += "MESSAGE motion : SIGNAL\n";
    out += std::string("SKILL s\n") + (driver_ ? "  SENSOR DRIVER SD1\n" : "") + "  LOGICAL SENSOR " + names +
           "\n" + (mover ? "  MACHINE CONTROLLER MC1\n" : "") +
           "  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n  COMPLETION 2 ERROR\nEND SKILL\n";
    if (driver_) {
      out +=
          "Sensor Driver: SD1\nBEGIN\n  REPEAT\n    WTM( request raw from LS1 )\n    TXM( raw to LS1 )\n  "
          "UNTIL( forever )\nEND\n";
    }
    for (int i = 1; i <= sensors_; ++i) out += sensor(i);
    if (mover) {
      out +=
          "Machine Controller: MC1\nBEGIN\n  REPEAT\n    TXM( request motion from SM1 )\n    WTM( motion "
          "from SM1 )\n  UNTIL( forever )\nEND\n";
    }
    out += "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n";
    for (int i = 1; i <= sensors_; ++i) out += "  SPC( c" + std::to_string(i) + " = FALSE )\n";
    if (gate_) out += set_gate();
    out += "  SPC( reached = FALSE )\n  SPC( lost = FALSE )\n  CONCURRENT\n" + blocks();
    out += block(moving(mover)) + "  END CONCURRENT\n";
    if (chance_(3) == 0) out += sample(1 + chance_(sensors_));
    if (mover && chance_(2) == 0) {
      out +=
          "  CASE\n  ( lost = TRUE ):\n    WTM( request motion from MC1 )\n    TXM( motion to MC1 )\n  ( "
          "lost "
          "= FALSE ): Do Nothing\n  END CASE\n";
    }
    return out + "  TXM( Completion Protocol 0 )\nEND\n";
  }

 private:
  static std::string block(const std::string& body) { return "  BEGIN\n" + body + "  END\n"; }
  static std::string looped(const std::string& body, const std::string& until) {
    return "  REPEAT\n" + body + "  UNTIL( " + until + " )\n";
  }
  static std::string forked(const std::string& blocks) {
    return "  CONCURRENT\n" + blocks + "  END CONCURRENT\n";
  }

  std::string set_gate() {
    static const std::vector<std::string> values = {"gate", "gate = TRUE", "gate = FALSE"};
    return "  SPC( " + values[static_cast<std::size_t>(chance_(3))] + " )\n";
  }

  /// Mostly one answer a request.
  std::string sensor(int i) {
    const auto n = std::to_string(i);
    const std::string take = "    WTM( request value" + n + " from SM1 )\n";
    std::string give = "    TXM( value" + n + " to SM1 )\n";
    if (gate_ && chance_(2) == 0)
      give = "    CASE\n    ( gate = TRUE ):\n" + give + "    ( gate = FALSE ): Do Nothing\n    END CASE\n";
    else if (i == 1 && driver_)
      give =
          "    REPEAT\n    TXM( request raw from SD1 )\n    WTM( raw from SD1 )\n    UNTIL( gate )\n" + give;
    static const std::vector<std::string> orders = {"wt", "wt", "wt", "wt", "wwt", "wtwwt", "wwtt", "t"};
    std::string body;
    for (const char step : orders[static_cast<std::size_t>(chance_(8))]) body += step == 'w' ? take : give;
    return "Logical Sensor: LS" + n + "\nBEGIN\n  REPEAT\n" + body + "  UNTIL( forever )\nEND\n";
  }

  std::string sample(int i) {
    const auto n = std::to_string(i);
    const std::string wait = "  WTM( value" + n + " from LS" + n + " )";
    std::string out = "  TXM( request value" + n + " from LS" + n + " )\n" + wait;
    out += chance_(8) == 0 ? " WITHIN 1 ms\n    Do Nothing\n  ELSE\n    SPC( lost )\n  END WTM\n" : "\n";
    switch (chance_(6)) {
      case 0:
        return out;
      case 1:
        return out + "  CASE\n  ( c" + n + " = TRUE ): SPC( c" + n + " = FALSE )\n  ( c" + n +
               " = FALSE ): SPC( c" + n + " )\n  END CASE\n";
      default:
        return out + "  SPC( c" + n + " )\n";
    }
  }

  /// One block or two, with each sensor in one of them.
  std::string blocks() {
    const std::string last = sensors_ == 3 ? sample(3) : "";
    const auto ends = [&] { return chance_(2) == 0 ? "forever" : any(); };
    switch (chance_(6)) {
      case 5:  // both once
        return block(sample(1) + sample(2)) + (last.empty() ? "" : block(looped(last, ends())));
      case 0:  // two that are asked together, again and again
        return block(looped(forked(block(sample(1)) + block(sample(2))), "forever")) +
               (last.empty() ? "" : block(looped(last, "forever")));
      case 1:  // one for ever until the other has ended, again and again
        return block(
            looped(forked(block(looped(sample(1), "forever")) + block(sample(2) + last)), "forever"));
      case 2:
        return block(looped(forked(block(looped(sample(1), "forever")) + block(looped(sample(2), any()))),
                            ends())) +
               (last.empty() ? "" : block(looped(last, ends())));
      case 3:  // three deep
        return block(looped(
            forked(block(looped(forked(block(looped(sample(1), "forever")) + block(sample(2))), "forever")) +
                   block(last.empty() ? "  SPC( reached )\n" : last)),
            "forever"));
      default:
        return block(looped(sample(1), ends())) + block(looped(sample(2) + last, ends()));
    }
  }

  std::string any() {
    std::string out = chance_(2) == 0 ? "reached OR lost" : "lost";
    for (int i = 1; i <= sensors_; ++i) {
      if (chance_(3) != 0) out += " OR c" + std::to_string(i);
    }
    return out;
  }

  std::string moving(bool mover) {
    std::string body;
    if (mover && chance_(4) != 0) body += "  WTM( request motion from MC1 )\n";
    if (chance_(2) == 0)
      body += "  CASE\n  ( c1 OR c2 ): SPC( lost )\n  ( NOT ( c1 OR c2 ) ): SPC( reached )\n  END CASE\n";
    else
      body += "  SPC( reached )\n";
    if (mover) body += "  TXM( motion to MC1 )\n";
    if (gate_ && chance_(4) == 0) body += set_gate();
    if (mover && chance_(4) == 0) return looped(body, "forever");
    return chance_(5) == 0 ? body : looped(body, any());
  }

  Chance chance_;
  int sensors_ = 2;
  bool gate_ = false;
  bool driver_ = false;  // of the first sensor, which asks it until the gate is open
};

}  // namespace pal::test
