// The duration of an operation, way by way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/icon_times.hpp"
#include "operations/model.hpp"
#include "pal/support/time.hpp"

namespace pal::operations {

/// One way from START to an end, on which the token comes to no icon twice.
struct WayThrough {
  /// "touch (0)": a skill with its code. A way through a sub-operation has the icons inside, if they are few;
  /// else the hierarchical icon with its code.
  std::vector<std::string> icons;
  std::string end;
  Duration shortest{};                 // what is known to pass at least: the delays
  std::optional<Duration> longest;     // nothing: some skill has no bound
  std::vector<std::string> unbounded;  // skills without one, "the sensor NAME" and the like, each once
  bool declared = false;               // some of its times are declared, not proved
  std::size_t alike = 1;               // ways of which the same is told, and which stand here once
};

struct Ways {
  std::vector<WayThrough> ways;
  bool complete = true;  // false: there are more than `most`, or too many to look at
};

/// Ways of the first operation, without those that end because no icon handles a code. Ways of which the same
/// is told are one. The program has no errors. The time grows with the size of the program. `stop` ends the
/// search, which is not complete then.
Ways ways_through(const Program& program, const Skills& skills, const SkillTimes& times,
                  std::size_t most = 64, const Stop& stop = {});

}  // namespace pal::operations
