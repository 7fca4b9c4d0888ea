// What one exploration measures.
#pragma once

#include <vector>

#include "analyzer/problem.hpp"

namespace pal::analyzer {

/// A requirement's measure as the machine follows it. Nothing is watched by default.
struct Watch {
  enum class Kind { nothing, age, response };
  Kind kind = Kind::nothing;
  int condition = -1;  // age
  int event = -1;      // response: channel
  std::vector<bool> at;

  // Age, by step: where what a thread has read can still count, and where a read that can count lies ahead.
  // What does not count any more is forgotten, which keeps the exploration small.
  std::vector<bool> counts;
  std::vector<bool> read_ahead;
};

Watch watch_of(const Problem& problem, const Requirement& requirement);

/// Whether a test of `step` looks at `condition`.
bool tests(const Step& step, int condition);

}  // namespace pal::analyzer
