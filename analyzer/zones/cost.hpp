// The approximate costs of classes: with many timers, fewer classes are expanded and kept.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "analyzer/zones/successors.hpp"

namespace pal::analyzer {

/// As much work as 2048 classes with about twenty timers. Each of their successors has a zone of its own.
constexpr std::size_t batch_work = std::size_t{1} << 28U;

/// The cost of expanding a class: for each timer that may fire first, its zone is closed once for each of the
/// others.
inline std::size_t work_of(const Dbm& zone, std::size_t timers) {
  return timers * timers * zone.size() * zone.size();
}

/// The memory that `classes` classes may take, with their places, in bytes. A small number may take what it
/// needs.
constexpr std::size_t memory_for(std::size_t classes) {
  constexpr std::size_t least = std::size_t{1} << 27U;
  constexpr std::size_t a_class = 4096;
  return std::max(least, std::min(classes, SIZE_MAX / a_class) * a_class);
}

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
