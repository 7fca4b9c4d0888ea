// The duration of an operation, way by way.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "operations/check.hpp"
#include "operations/model.hpp"
#include "pal/support/time.hpp"

namespace pal::operations {

/// The longest time of a skill to a completion code, where it is proved.
using SkillTimes = std::map<std::pair<std::string, int>, Duration>;

/// One way from START to an end, on which the token comes to no icon twice.
struct WayThrough {
  std::vector<std::string> icons;  // "touch (0)": a skill with its code
  std::string end;
  Duration shortest{};                 // what is known to pass at least: the delays
  std::optional<Duration> longest;     // nothing: some skill has no bound
  std::vector<std::string> unbounded;  // skills without one and "the sensor NAME", each once
};

struct Ways {
  std::vector<WayThrough> ways;
  bool complete = true;  // false: there are more than `most`
};

/// Ways of the first operation, without those that end because no icon handles a code. The program has no
/// errors.
Ways ways_through(const Program& program, const Skills& skills, const SkillTimes& times,
                  std::size_t most = 64);

}  // namespace pal::operations
