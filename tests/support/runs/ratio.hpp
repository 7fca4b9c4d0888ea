// The greatest ratio of work to time on a cycle, found in the plainest way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pal::test {

struct Stretch {
  std::size_t from = 0;
  std::size_t to = 0;
  std::int64_t work = 0;
  std::int64_t time = 0;
};

/// work / time; 0 / 1 if no cycle takes time.
struct Ratio {
  std::int64_t work = 0;
  std::int64_t time = 1;
};

/// Of the cycles that take time in a graph of `nodes` nodes.
Ratio greatest_ratio(std::size_t nodes, const std::vector<Stretch>& stretches);

}  // namespace pal::test
