// A contingency module with a CONCURRENT, for random skills that execute it in blocks of their own.
#pragma once

#include <cstdint>
#include <string>

#include "tests/support/chance.hpp"

namespace pal::test {

/// Drawn apart from the skill that it is put in, so that the skill is the same without. One seed in `one_in`
/// has it. The same seed gives the same text.
class ExecutedBlocks {
 public:
  ExecutedBlocks(std::uint64_t seed, int one_in) : chance_(~seed), there_(chance_(one_in) == 0) {}

  bool there() const { return there_; }

  /// For the skill's template.
  std::string contingency() const { return there_ ? "  CONTINGENCY 1 \"mended\" METHOD CM1\n" : ""; }

  /// A statement for a body or a block: executes the module, or nothing.
  std::string call() {
    if (!there_ || chance_(2) == 0) return "";
    return chance_(6) == 0 ? "      CM1\n      Execute CM1\n" : "      Execute CM1\n";
  }

  /// The body of the skill method, in which the module is executed somewhere.
  std::string executed_in(std::string method) {
    const std::string start = "WTM( Coordinator )\n";
    first_ = method.find("CM1") == std::string::npos;
    if (there_ && first_) method.insert(method.find(start) + start.size(), "  Execute CM1\n");
    return method;
  }

  /// The module, which may read `condition`; not if it is the first thing that the method does.
  std::string module(const std::string& condition) {
    if (!there_) return "";
    std::string out = "Contingency Module: CM1\n  ACTIVITY mend\n  ACTIVITY tidy\nBEGIN\n";
    if (chance_(3) == 0) out += "  mend\n";
    const std::string ends = !first_ && chance_(3) == 0
                                 ? "  RPC( " + condition + " )\n  CASE\n    ( " + condition +
                                       " ): mend\n    ( NOT " + condition + " ): tidy\n  END CASE\n"
                                 : "  mend\n";
    const std::string within = "  CONCURRENT BEGIN tidy END BEGIN mend tidy END END CONCURRENT\n";
    std::string other = "  tidy\n";
    if (chance_(3) == 0) other = "  REPEAT\n    tidy\n  UNTIL( forever )\n";
    if (chance_(4) == 0) other = within;
    out += "  CONCURRENT\n  BEGIN\n" + ends + "  END\n  BEGIN\n" + other + "  END\n  END CONCURRENT\n";
    if (chance_(3) == 0) out += "  tidy\n";
    return out + "END\n";
  }

  /// For the environment: some places, and the times.
  std::string times_and_places(int processors) {
    if (!there_) return "";
    std::string out = "  TIME mend : " + interval() + "\n  TIME tidy : " + interval() + "\n";
    for (const char* thread : {"CM1.1", "CM1.2", "SM1.1/CM1.1", "SM1.2/CM1.2"}) {
      if (chance_(3) == 0)
        out += std::string("  PLACE ") + thread + " ON P" + std::to_string(chance_(processors)) +
               " PRIORITY " + std::to_string(1 + chance_(4)) + "\n";
    }
    return out;
  }

 private:
  std::string interval() { return chance_(3) == 0 ? "1 TO 2 ms" : std::to_string(1 + chance_(2)) + " ms"; }

  Chance chance_;
  bool there_;
  bool first_ = false;
};

}  // namespace pal::test
