// Which channels, conditions and blocks each thread uses.
#pragma once

#include <set>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// Of one thread, without its blocks.
struct ThreadTalk {
  std::vector<StepId> steps;
  std::vector<StepId> beginning;  // those that come once at most, before a round or blocks
  std::set<ChannelId> sends;
  std::set<ChannelId> waits;
  std::set<ThreadId> blocks;
  std::set<ConditionId> sets;   // conditions
  std::set<ConditionId> reads;  // conditions, by READ or a test
  std::set<KeptId> keeps;       // in Problem::kept: by a wait, or an activity that writes it
  std::set<KeptId> uses;        // in Problem::kept
  // The subset that it may come to more than once.
  std::set<ChannelId> sends_again;
  std::set<ChannelId> waits_again;
  std::set<ThreadId> blocks_again;
};

Table<ThreadId, ThreadTalk> talk_of(const Problem& problem);

/// The least time that a wait takes. It is known if the wait has no limit and is for the answer of a device
/// that this thread alone asks, just before. Otherwise 0.
Nanoseconds least_wait(const Problem& problem, const Table<ThreadId, ThreadTalk>& talk, ThreadId thread,
                       StepId step);

}  // namespace pal::analyzer
