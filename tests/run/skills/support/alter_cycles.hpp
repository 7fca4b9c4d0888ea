// How often ALTER asked in the runs of a skill, and how often it got no answer.
#pragma once

#include <cstddef>

#include "pal/trace/trace.hpp"

namespace pal::test {

struct AlterCycles {
  std::size_t asked = 0;
  /// Requests that the next one came before, and requests that found the last one still waiting.
  std::size_t missed = 0;

  /// Adds those of a run. A request that the skill's end leaves open is not missed.
  void count(const trace::Trace& run);
};

}  // namespace pal::test
