// Random programs, of every form of statement: for what must hold of any program, sensible or not.
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace pal::test {

inline const std::string program_declarations = R"(MESSAGE force : REAL N
MESSAGE tick : SIGNAL
MESSAGE motion : dz : REAL mm
CONDITION near FROM force
CONDITION far
DEVICE clock
Logical Sensor: LS1
Machine Controller: MC1
Contingency Module: CM1
BEGIN
  CONCURRENT
  BEGIN
    Do Nothing
  END
  BEGIN
    Do Nothing
  END
  END CONCURRENT
END
)";

/// The canonical text of a skill module SM1 over `program_declarations`. The same seed gives the same text.
class RandomProgram {
 public:
  /// `reachable`: no statement stands where no flow can reach it.
  explicit RandomProgram(std::uint64_t seed, bool reachable = false) : engine_(seed), reachable_(reachable) {}

  std::string module() {
    return "Skill Module: SM1\n" + descriptions() + "  ACTIVITY think READS force WRITES motion\nBEGIN\n" +
           list(1, 4) + "END\n";
  }

 private:
  /// Of the characters that a text may have, those that DOT and lists of attributes read as something else
  /// among them.
  std::string descriptions() {
    static const std::string pieces[] = {"a", " ", ";", "\\\"", "\\\\", "%",  "%3B",   "<",
                                         ">", "é", "…", "#",    "=",    "[]", "\\\\n", "&amp;"};
    std::string out;
    for (unsigned texts = below(3); texts > 0; --texts) {
      out += "  DESCRIPTION \"";
      for (unsigned length = below(12); length > 0; --length) out += pieces[below(16)];
      out += "\"\n";
    }
    return out;
  }

  unsigned below(unsigned n) { return static_cast<unsigned>(engine_() % n); }
  static std::string indent(unsigned depth) { return std::string(2 * depth, ' '); }

  std::string list(unsigned depth, unsigned deeper) {
    std::string out;
    ended_ = false;
    for (unsigned count = below(4); count > 0 && !(reachable_ && ended_); --count)
      out += statement(depth, deeper);
    return out;
  }

  std::string atom() {
    return std::string(below(2) == 0 ? "near" : "far") + (below(2) == 0 ? " = TRUE" : " = FALSE");
  }
  std::string guard() {
    switch (below(6)) {
      case 0:
        return atom() + " AND " + atom();
      case 1:
        return atom() + " OR " + atom();
      case 2:
        return "NOT ( " + atom() + " )";
      case 3:
        return "( " + atom() + " OR " + atom() + " ) AND NOT ( " + atom() + " AND " + atom() + " )";
      default:
        return atom();
    }
  }

  std::string statement(unsigned depth, unsigned deeper) {
    const std::string line = indent(depth);
    switch (below(deeper == 0 ? 12 : 18)) {
      case 0:
        return line + "WTM( Coordinator )\n";
      case 1:
        return line + "WTM( force from LS1 )\n";
      case 2:
        return line + "TXM( motion to MC1 )\n";
      case 3:
        return line + "TXM( request force from LS1 )\n";
      case 4:
        return line + "TXM( Completion Protocol " + std::to_string(below(3)) + " )\n";
      case 5:
        return line + "SPC( near )\n";
      case 6:
        return line + "SPC( near = TRUE )\n";
      case 7:
        return line + "SPC( near = FALSE )\n";
      case 8:
        return line + "RPC( near )\n";
      case 9:
        return line + "think\n";
      case 10:
        return line + "Execute CM1\n";
      case 11:
        return line + "Do Nothing\n";
      case 12: {
        const std::string body = list(depth + 1, deeper - 1);
        const bool ended = ended_;
        std::string out = line + "WTM( force from LS1 ) WITHIN 4 ms\n" + body + line + "ELSE\n";
        out += list(depth + 1, deeper - 1) + line + "END WTM\n";
        ended_ = ended && ended_;
        return out;
      }
      case 13: {
        const bool within = below(2) == 0;
        std::string out = line + "WTM FIRST" + (within ? " WITHIN 100 us" : "") + "\n";
        bool ended = true;
        for (const char* source : {"tick from clock", "motion request from MC1", "force from LS1"}) {
          const std::string message =
              std::string(source) == "motion request from MC1" ? "request motion from MC1" : source;
          out += line + "  ( " + message + " ):\n" + list(depth + 2, deeper - 1);
          ended = ended && ended_;
        }
        if (within) {
          out += line + "ELSE\n" + list(depth + 1, deeper - 1);
          ended = ended && ended_;
        }
        ended_ = ended;
        return out + line + "END WTM\n";
      }
      case 14: {
        std::string out = line + "CASE\n";
        bool ended = true;
        for (unsigned arms = 1 + below(3); arms > 0; --arms) {
          out += line + "  ( " + guard() + " ):\n" + list(depth + 2, deeper - 1);
          ended = ended && ended_;
        }
        ended_ = ended;
        return out + line + "END CASE\n";
      }
      case 15:
      case 16: {
        const std::string body = list(depth + 1, deeper - 1);
        const bool forever = below(2) == 0;
        ended_ = ended_ || forever;
        return line + "REPEAT\n" + body + line + "UNTIL( " + (forever ? "forever" : guard()) + " )\n";
      }
      default: {
        std::string out = line + "CONCURRENT\n";
        for (unsigned blocks = 1 + below(3); blocks > 0; --blocks)
          out += line + "BEGIN\n" + list(depth + 1, deeper - 1) + line + "END\n";
        ended_ = false;
        return out + line + "END CONCURRENT\n";
      }
    }
  }

  std::mt19937_64 engine_;
  bool reachable_;
  bool ended_ = false;  // no flow leaves the list that was written last
};

}  // namespace pal::test
