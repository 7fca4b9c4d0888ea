// What classes cost, about: of those with many timers fewer are expanded, and kept.
#pragma once

#include <cstddef>

#include "analyzer/zones/move.hpp"

namespace pal::analyzer {

/// As much work as 2048 classes with some twenty timers. Each of their successors has a zone of its own.
constexpr std::size_t batch_work = std::size_t{1} << 28U;

/// To expand a class: for each timer that may fire first its zone is closed once for each of the others.
inline std::size_t work_of(const Dbm& zone, std::size_t timers) {
  return timers * timers * zone.size() * zone.size();
}

/// What a class may take of memory, with its part of what its place takes, in bytes.
constexpr std::size_t memory_a_class = 8192;

inline std::size_t memory_of(const Dbm& zone) {
  return zone.size() * zone.size() * sizeof(std::int64_t);
}

/// Each move has a state of its own.
inline std::size_t memory_of_moves(const Place& place) {
  const State& state = place.state;
  return place.moves.size() *
         (state.threads.size() * sizeof(ThreadState) + state.slots.size() * sizeof(SlotState) + sizeof(Move));
}

}  // namespace pal::analyzer
