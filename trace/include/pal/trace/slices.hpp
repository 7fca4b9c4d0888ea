// A trace regrouped by actor: what each thread and device did from when to when.
#pragma once

#include <cstdint>
#include <vector>

#include "pal/trace/trace.hpp"

namespace pal::trace {

/// What an actor does during a slice.
enum class State : std::uint8_t {
  running,  // has its processor
  ready,    // could run, but the processor is taken
  waiting,  // needs no processor: for a message, a free slot, its blocks, or the start
  serving,  // a device is busy
};

/// How a slice ended.
enum class Ending : std::uint8_t {
  effect,     // running: the statement had its effect
  preempted,  // running: another thread took the processor; the statement goes on in a later slice
  blocked,    // running: the statement has to wait before its effect (a send that finds its slot full)
  over,       // ready, waiting: what was waited for came; serving: the device is done
  gave_up,    // waiting: the time of a WITHIN ran out
  cancelled,  // the thread, a block of CONCURRENT, was stopped
  open,       // the trace ends first
};

/// [from_ns, to_ns], to_ns >= from_ns. `statement`, `channel` index the tables of the trace; -1: none.
struct Slice {
  std::int32_t actor = -1;
  State state = State::running;
  Ending ending = Ending::open;
  std::int32_t statement = -1;
  std::int32_t channel = -1;  // waiting: the channel, or -1 for the start and for blocks
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;

  friend bool operator==(const Slice&, const Slice&) = default;
};

/// Every slice, in the order of their beginnings; slices of one actor never overlap. Of slices of no length
/// only those that end with an effect are kept, because a statement that costs nothing still has its effect.
/// Open slices end with the last event, or at `known_until_ns` if it is known that nothing more happens up to
/// then. The rules are in docs/reference/trace.md.
std::vector<Slice> slices(const Trace& trace, std::int64_t known_until_ns = 0);

}  // namespace pal::trace
