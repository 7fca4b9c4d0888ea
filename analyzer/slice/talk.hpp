// Which thread uses what: channels, conditions, blocks.
#pragma once

#include <set>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// Of one thread, without its blocks.
struct ThreadTalk {
  std::vector<int> steps;
  std::set<int> sends;   // channels
  std::set<int> waits;   // channels
  std::set<int> blocks;  // threads
  std::set<int> sets;    // conditions
  std::set<int> reads;   // conditions, by READ or a test
  // Of these what it may come to more than once.
  std::set<int> sends_again;
  std::set<int> waits_again;
  std::set<int> blocks_again;
};

/// By thread.
std::vector<ThreadTalk> talk_of(const Problem& problem);

/// Whether the device of `channel` serves, or sends, what goes over it: what else is sent to a device it
/// takes at once.
bool device_matters(const Problem& problem, int channel);

}  // namespace pal::analyzer
