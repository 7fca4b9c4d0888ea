// Skills of twelve modules and eight conditions, in the shapes that robot skills have: for measuring, and for
// what must hold at that size. Ten modules are five logical sensors, each with a driver of its own; the
// others are the method and the robot.
#pragma once

#include <string>

namespace pal::test {

enum class Shape {
  star,        // one after the other: ask every sensor, take every answer, decide, move
  concurrent,  // a block for each sensor, for ever; the block that moves ends and cancels them
  chain,       // each logical sensor asks the next one by way of the method; one result passes through all
  couriers,    // asked again before the last answer is worked on; every sensor's next answer is on its way
  polling,     // every wait of method and robot gives up
  nested,      // blocks within blocks, some of which end
};

inline constexpr int sensors = 5;

class LargeSkill {
 public:
  /// `flaw`: one of the modules talks in the wrong order, so that the skill can stand still.
  explicit LargeSkill(Shape shape, bool flaw = false) : shape_(shape), flaw_(flaw) {}

  std::string text() const {
    std::string out = "DEVICE robot\nMESSAGE tick : SIGNAL\nMESSAGE motion : dz : REAL mm\n";
    out += "MESSAGE correction : dz : REAL mm\nCONDITION reached\nCONDITION lost\nCONDITION home\n";
    std::string drivers;
    std::string logical;
    for (int i = 1; i <= sensors; ++i) {
      const auto n = std::to_string(i);
      out += "DEVICE sensor" + n + "\nMESSAGE raw" + n + " : REAL N\nMESSAGE value" + n + " : REAL N\n";
      out += "CONDITION c" + n + " FROM value" + n + "\n";
      drivers += (i == 1 ? "" : ", ") + ("SD" + n);
      logical += (i == 1 ? "" : ", ") + ("LS" + n);
    }
    out += "SKILL s\n  SENSOR DRIVER " + drivers + "\n  LOGICAL SENSOR " + logical;
    out +=
        "\n  MACHINE CONTROLLER MC1\n  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n  COMPLETION 2 ERROR\nEND "
        "SKILL\n";
    for (int i = 1; i <= sensors; ++i) out += sensor(i);
    return out + controller() + "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n" + initial() + method() +
           "  TXM( Completion Protocol 0 )\nEND\n";
  }

 private:
  static std::string ask(int i) {
    return "TXM( request value" + std::to_string(i) + " from LS" + std::to_string(i) + " )\n";
  }
  static std::string wait(int i) {
    return "WTM( value" + std::to_string(i) + " from LS" + std::to_string(i) + " )";
  }
  static std::string take(int i) { return wait(i) + "\nSPC( c" + std::to_string(i) + " )\n"; }

  std::string sensor(int i) const {
    const auto n = std::to_string(i);
    const auto ask_device = "    TXM( request raw" + n + " from sensor" + n + " )\n    WTM( raw" + n +
                            " from sensor" + n + " )\n";
    std::string out = "Sensor Driver: SD" + n + "\nBEGIN\n  REPEAT\n    WTM( request raw" + n + " from LS" +
                      n + " )\n" + ask_device + "    TXM( raw" + n + " to LS" + n +
                      " )\n  UNTIL( forever )\nEND\n";
    out += "Logical Sensor: LS" + n + "\nBEGIN\n  REPEAT\n    WTM( request value" + n +
           " from SM1 )\n    TXM( request raw" + n + " from SD" + n + " )\n";
    if (flaw_ && i == 3) out += "    WTM( request value3 from SM1 )\n";
    return out + "    WTM( raw" + n + " from SD" + n + " )\n    TXM( value" + n +
           " to SM1 )\n  UNTIL( forever )\nEND\n";
  }

  std::string controller() const {
    return "Machine Controller: MC1\nBEGIN\n  REPEAT\n    WTM( tick from robot )\n    TXM( request motion "
           "from SM1 )\n" +
           std::string(shape_ == Shape::polling ? "    WTM( motion from SM1 ) WITHIN 4 ms\n      Do "
                                                  "Nothing\n    ELSE\n      Do Nothing\n    END WTM\n"
                                                : "    WTM( motion from SM1 )\n") +
           "    TXM( correction to robot )\n  UNTIL( forever )\nEND\n";
  }

  static std::string initial() {
    std::string out;
    for (int i = 1; i <= sensors; ++i) out += "SPC( c" + std::to_string(i) + " = FALSE )\n";
    return out + "SPC( reached = FALSE )\nSPC( lost = FALSE )\nSPC( home = FALSE )\n";
  }

  static std::string any() {
    std::string out;
    for (int i = 1; i <= sensors; ++i) out += (i == 1 ? "c" : " OR c") + std::to_string(i);
    return out;
  }

  static std::string move() {
    return "WTM( motion request from MC1 )\nCASE\n( " + any() + " ): SPC( lost )\n( NOT ( " + any() +
           " ) ): SPC( reached )\nEND CASE\nTXM( motion to MC1 )\n";
  }
  static std::string retreat() {
    return "CASE\n( lost = TRUE ):\nREPEAT\nWTM( motion request from MC1 )\nTXM( motion to MC1 )\nSPC( home "
           ")\nUNTIL( home )\n"
           "( lost = FALSE ): Do Nothing\nEND CASE\n";
  }

  static std::string sample(int i) { return ask(i) + take(i); }
  static std::string block(const std::string& body) { return "BEGIN\n" + body + "END\n"; }
  static std::string for_ever(const std::string& body) { return "REPEAT\n" + body + "UNTIL( forever )\n"; }

  std::string method() const {
    std::string asks;
    std::string takes;
    for (int i = 1; i <= sensors; ++i) {
      asks += ask(i);
      takes += take(i);
    }
    const std::string moving = "REPEAT\n" + move() + "UNTIL( reached OR lost OR " + any() + " )\n";
    std::string out;
    switch (shape_) {
      case Shape::star:
        return "REPEAT\n" + asks + takes + move() + "UNTIL( reached OR lost )\n" + retreat();
      case Shape::concurrent:
        for (int i = 1; i <= sensors; ++i) out += block(for_ever(sample(i)));
        return "CONCURRENT\n" + out + block(moving) + "END CONCURRENT\n" + retreat();
      case Shape::chain:
        for (int i = 1; i <= sensors; ++i) {
          out += sample(i) + "CASE\n( c" + std::to_string(i) + " = TRUE ): SPC( lost )\n( c" +
                 std::to_string(i) + " = FALSE ): Do Nothing\nEND CASE\n";
        }
        return "REPEAT\n" + out + move() + "UNTIL( reached OR lost )\n" + retreat();
      case Shape::couriers:
        for (int i = 1; i <= sensors; ++i)
          out += wait(i) + "\n" + ask(i) + "SPC( c" + std::to_string(i) + " )\n";
        return "CONCURRENT\n" + block(asks + for_ever(out)) + block(moving) + "END CONCURRENT\n" + retreat();
      case Shape::polling:
        for (int i = 1; i <= sensors; ++i) {
          out += ask(i) + wait(i) + " WITHIN 3 ms\nSPC( c" + std::to_string(i) +
                 " )\nELSE\nSPC( lost )\nEND WTM\n";
        }
        return "REPEAT\n" + out +
               "WTM( motion request from MC1 ) WITHIN 30 ms\nTXM( motion to MC1 )\nSPC( reached )\nELSE\nDo "
               "Nothing\nEND WTM\n"
               "UNTIL( reached OR lost OR " +
               any() + " )\n";
      case Shape::nested:
        return "CONCURRENT\n" +
               block(for_ever("CONCURRENT\n" + block(sample(1)) + block(sample(2)) + "END CONCURRENT\n")) +
               block(for_ever("CONCURRENT\n" + block(for_ever(sample(3))) + block(sample(4) + sample(5)) +
                              "END CONCURRENT\n")) +
               block(moving) + "END CONCURRENT\n" + retreat();
    }
    return out;
  }

  Shape shape_;
  bool flaw_;
};

}  // namespace pal::test
