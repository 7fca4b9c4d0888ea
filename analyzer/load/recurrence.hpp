// The parts of a skill's runs that can go on for ever, and the threads in them.
#pragma once

#include <unordered_set>
#include <vector>

#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

/// A strongly connected part of a zone graph, with at least one edge.
struct Recurrence {
  std::vector<int> classes;
  std::vector<int> entries;  // classes that are reached from outside, or that the skill begins in
  std::vector<int> fired;    // timers that fire inside
  std::vector<int> edges;    // of the graph, inside
};

std::vector<Recurrence> recurrences(const ZoneGraph& graph);

/// Threads, channels and devices that influence one another while a skill stays in a recurrence. Influence
/// through the values of conditions does not count.
struct Slice {
  Table<ThreadId, bool> threads;
  Table<ChannelId, bool> channels;
  Table<DeviceId, bool> devices;
  std::vector<bool> timers;
  /// Threads outside that are active: they are left out.
  Table<ThreadId, bool> left_out;
  /// Conditions that left-out threads set: they may have any value.
  std::uint64_t free_conditions = 0;
  Table<StepId, bool> steps;  // of the slice's threads, while in the recurrence
  /// Where the slice's threads are while the skill stays in the recurrence.
  std::unordered_set<std::uint64_t> positions;
};

/// The slice that `processor` belongs to; without threads if nothing runs there again and again.
Slice slice_of(const Machine& machine, const ZoneGraph& graph, const Recurrence& recurrence,
               ProcessorId processor);

/// A number for the steps and status of the slice's threads.
std::uint64_t position(const Slice& slice, const State& state);

}  // namespace pal::analyzer
