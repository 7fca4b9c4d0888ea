// Which thread uses what: channels, conditions, blocks.
#pragma once

#include <set>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// Of one thread, without its blocks.
struct ThreadTalk {
  std::vector<int> steps;
  std::vector<int> beginning;  // those that come once at most, before a round or blocks
  std::set<int> sends;         // channels
  std::set<int> waits;         // channels
  std::set<int> blocks;        // threads
  std::set<int> sets;          // conditions
  std::set<int> reads;         // conditions, by READ or a test
  // Of these what it may come to more than once.
  std::set<int> sends_again;
  std::set<int> waits_again;
  std::set<int> blocks_again;
};

/// By thread.
std::vector<ThreadTalk> talk_of(const Problem& problem);

/// A wait for what a device answers, in a thread that alone asks it, just before, and waits without limit:
/// the least time that it waits. Else 0.
Nanoseconds least_wait(const Problem& problem, const std::vector<ThreadTalk>& talk, int thread, int step);

}  // namespace pal::analyzer
