// Which placements of a skill's threads meet every requirement, and how few processors do.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/whatif/judge.hpp"

namespace pal::analyzer {

/// Where a thread runs.
struct Seat {
  std::string thread;
  int processor = 0;
  int priority = 0;
};

struct Placed {
  std::vector<Seat> seats;
  Ruling ruling;
};

/// Every placement on exactly `processors` processors, each with something to do.
struct Placements {
  int processors = 0;
  std::size_t tried = 0;
  std::vector<Placed> refuted;  // shown to break a requirement
  std::vector<Placed> meet;
  std::vector<Placed> undecided;
  std::vector<std::size_t> broken;  // by requirement: how many placements it was shown to fail in
  bool complete = true;             // all were tried
  bool interchangeable =
      true;  // processors are all alike: what differs in their names alone is one placement
};

struct PlacementOptions {
  bool priorities = false;       // also every order of the threads of a processor by priority
  bool first_is_enough = false;  // stop at the first that meets everything
  std::size_t most = 20'000;     // to try, of one number of processors
};

/// `environment` with its first `processors` processors (more like its last, if it has fewer) and each thread
/// where `seats` says.
pan::Environment placed(pan::Environment environment, int processors, const std::vector<Seat>& seats);

/// On exactly `processors`: those of the environment, in their order; where it has fewer, more like its last.
Placements placements_on(int processors, const pan::Environment& environment, Judge& judge,
                         const PlacementOptions& options);

/// One processor, two, … up to one a thread, until some placement meets everything. The last of the answer is
/// the least number that does, if one was found; that fewer do not is proved where those before are complete
/// and have nothing undecided.
std::vector<Placements> fewest_processors(const pan::Environment& environment, Judge& judge,
                                          const PlacementOptions& options);

}  // namespace pal::analyzer
