// One random run of a skill, with times and outcomes drawn by seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "analyzer/runs/concrete_run.hpp"

namespace pal::analyzer {

struct SimulationOptions {
  /// extremes: each time is its best or its worst, at random. What the skill leaves open (outcomes of
  /// conditions, orders at one instant) is drawn by seed in any case.
  enum class Times { worst, best, random, extremes };
  Times times = Times::worst;
  std::uint64_t seed = 1;
  /// If not 0: of what the skill leaves open, only once in so many draws another way is drawn than the first,
  /// by which conditions are FALSE. Most loops go on then.
  std::uint64_t seldom = 0;
  Nanoseconds until = 1'000'000'000;
  std::size_t max_events = 1'000'000;
  std::function<bool()> stop;  // asked at each event; where it says so the run is known no further
  bool record = true;
  bool hash_states = false;  // fills Simulation::states
  /// By device, where not empty: the instant of its first event or frame, counted from its opening; -1:
  /// drawn.
  Table<DeviceId, Nanoseconds> phases;
  /// The beginning of the run; the rest is drawn. The beginning ends before a scripted firing that is not
  /// possible.
  std::vector<ScriptedFiring> beginning;
};

struct Simulation {
  trace::Trace trace;
  std::vector<Measurement> measured;
  std::vector<ScriptedFiring> script;       // what fired: replay() makes the same run
  std::vector<std::size_t> measured_after;  // for each of `measured`: the number of firings before
  std::vector<std::size_t> states;          // behind each firing, if asked for: hash_of_snapshot()
  bool ended = false;                       // the skill did
  bool failed = false;                      // an event of what is watched can have no response
  Nanoseconds end = 0;                      // all that happens up to then is known
  bool still = false;                       // nothing happens after the end, ever
  bool stands = false;    // time stood still at the end: no more is known, it may be for ever
  Nanoseconds grown = 0;  // the greatest value that still grows at the end
};

/// The same options give the same run.
Simulation simulate(const Machine& machine, const SimulationOptions& options);

}  // namespace pal::analyzer
