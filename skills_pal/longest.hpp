// How long the skills take in this workcell at the most, by their parameters. Each skill's folder says its
// own.
#pragma once

#include <span>
#include <string_view>

namespace pal::skills {

/// Declared, not proved: a server, and a run of an operation, compare each run with it.
struct LongestTime {
  std::string_view skill;
  int code = 0;  // of the completion
  std::string_view
      seconds;  // a formula (operations/formula.hpp) of the parameters, each a number in its unit
};

/// Of the skills and codes that have one.
std::span<const LongestTime> longest_times();

}  // namespace pal::skills
