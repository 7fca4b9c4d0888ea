// A stretch of a run that begins and ends in one state, as a turn that is repeated for ever.
#pragma once

#include <optional>
#include <vector>

#include "analyzer/load/fraction.hpp"
#include "analyzer/runs/witness.hpp"

namespace pal::analyzer {

/// The firings of a run after the first `begin`, up to `end`. The machine is in the same state before and
/// after them.
struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A run without an end: its beginning and two turns, and the part of the time that it keeps a processor
/// busy, for ever.
struct UnendingRun {
  Witness witness;
  Fraction load;
};

/// Looks for times with which `script` up to `stretch.end` is a run, and everything after it can be repeated
/// every `period`, for ever. Actions of `processor` that begin in the stretch take their worst time. The
/// result has been replayed, and after the second turn everything is as it was after the first. Nothing if
/// there are no such times; nor if actions in the stretch are interrupted and the script's own times do not
/// repeat by themselves.
std::optional<UnendingRun> repeat(const Machine& machine, std::vector<ScriptedFiring> script, Stretch stretch,
                                  Nanoseconds period, ProcessorId processor);

}  // namespace pal::analyzer
