// Which placements of a skill's threads meet every requirement, and how few processors do.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/whatif/ids.hpp"
#include "analyzer/whatif/requirement_checker.hpp"

namespace pal::analyzer::whatif {

/// Where a thread runs.
struct ThreadPlacement {
  std::string thread;
  ProcessorId processor;
  int priority = 0;
};

struct Placed {
  std::vector<ThreadPlacement> threads;
  Ruling ruling;
};

/// Every placement on exactly `processors` processors, each with something to do. Of several that are alike
/// it does not matter which has what: such placements come once. Alike are those of one kind that no
/// requirement names.
struct Placements {
  int processors = 0;
  std::vector<std::string> names;  // by ThreadPlacement::processor, those that were added included
  std::size_t tried = 0;
  std::vector<Placed> refuted;  // shown to break a requirement
  std::vector<Placed> meet;
  std::vector<Placed> undecided;
  std::vector<std::size_t> broken;  // by RequirementId: how many placements it was shown to fail in
  bool complete = true;             // all were tried
};

struct PlacementOptions {
  bool priorities = false;  // also every order of the threads of a processor by priority, equals included
  bool first_is_enough = false;  // stop at the first that meets everything
  std::size_t most = 20'000;     // to try, of one number of processors
};

/// `environment` with each thread where `threads` says; if it has too few processors, with more like its
/// last.
pan::Environment placed(pan::Environment environment, const std::vector<ThreadPlacement>& threads);

/// On exactly `processors` of those of the environment, whichever they are; where it has fewer, on these and
/// more like its last.
Placements placements_on(int processors, const pan::Environment& environment, RequirementChecker& checker,
                         const PlacementOptions& options);

/// One processor, two, … up to one a thread, until some placement meets everything. The last of the answer is
/// the least number that suffices, if one was found. That fewer do not suffice is proved if those before are
/// complete and have nothing undecided.
std::vector<Placements> fewest_processors(const pan::Environment& environment, RequirementChecker& checker,
                                          const PlacementOptions& options);

}  // namespace pal::analyzer::whatif
