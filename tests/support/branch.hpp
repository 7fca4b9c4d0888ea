// A branch that a run may take or leave.
#pragma once

#include <string>

namespace pal::test {

/// Sets the condition, and does `then` where it is TRUE.
inline std::string branch(const std::string& condition, const std::string& then) {
  return "SPC( " + condition + " )\nCASE\n( " + condition + " ):\n" + then + "( NOT " + condition +
         " ): Do Nothing\nEND CASE\n";
}

}  // namespace pal::test
