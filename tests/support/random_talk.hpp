// Small skills by chance whose modules talk in any order, so that many of them get stuck.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace pal::test {

/// The text of a skill with one sensor, one controller and a method. The same seed gives the same text.
class RandomTalk {
 public:
  explicit RandomTalk(std::uint64_t seed) : engine_(seed) {}

  std::string text() {
    std::string out = R"(DEVICE robot
MESSAGE force : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
CONDITION d
SKILL s
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
END SKILL
Logical Sensor: LS1
BEGIN
  REPEAT
)";
    out += talk({"WTM( request force from SM1 )", "TXM( force to SM1 )"});
    out += "  UNTIL( forever )\nEND\nMachine Controller: MC1\nBEGIN\n  REPEAT\n";
    if (chance(2) != 0) out += "    WTM( tick from robot )\n";
    out += talk({"TXM( request motion from SM1 )", waits("motion", "SM1")});
    out +=
        "  UNTIL( forever )\nEND\nSkill Module: SM1\nBEGIN\n  WTM( Coordinator )\n  SPC( c )\n  SPC( d )\n";
    const auto sense = [&] {
      return talk({"TXM( request force from LS1 )", waits("force", "LS1"), "SPC( c )"});
    };
    const auto act = [&] {
      return talk({"WTM( request motion from MC1 )", "TXM( motion to MC1 )", "SPC( d )"});
    };
    if (chance(2) != 0) {
      out += "  CONCURRENT\n  BEGIN\n  REPEAT\n" + sense() + "  UNTIL( " +
             (chance(2) != 0 ? "forever" : "d") + " )\n  END\n  BEGIN\n  REPEAT\n" + act() +
             "  UNTIL( d )\n  END\n  END CONCURRENT\n";
    } else {
      out += "  REPEAT\n" + sense() + act() + "  UNTIL( c OR d )\n";
    }
    if (chance(2) != 0)
      out += "  CASE\n    ( c = TRUE ):\n" + act() + "    ( c = FALSE ): Do Nothing\n  END CASE\n";
    return out + "  TXM( Completion Protocol 0 )\nEND\n";
  }

 private:
  int chance(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }

  std::string waits(const std::string& message, const std::string& from) {
    const auto wait = "WTM( " + message + " from " + from + " )";
    return chance(3) != 0 ? wait
                          : wait + " WITHIN 1 ms\n      Do Nothing\n    ELSE\n      Do Nothing\n    END WTM";
  }

  /// The statements, mostly in order; now and then two change places, or one comes twice.
  std::string talk(std::vector<std::string> statements) {
    if (chance(4) == 0) std::swap(statements[0], statements[1]);
    if (chance(6) == 0) statements.push_back(statements[static_cast<std::size_t>(chance(2))]);
    std::string out;
    for (const auto& statement : statements) out += "    " + statement + "\n";
    return out;
  }

  std::mt19937_64 engine_;
};

}  // namespace pal::test
