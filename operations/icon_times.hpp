// How long the icons of an operation take, as far as it is proved.
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

/// Of one run; without a time, why none is known: "touch", "the sensor force-z".
struct Longest {
  std::optional<Duration> time;
  std::string unknown;
};
/// Of a sensor and of a person nothing is proved.
Longest longest_of(const Icon& icon, int code, const SkillTimes& times);
/// Nothing: it is too long to be told.
std::optional<Duration> multiplied(Duration time, double by);

/// All runs of an icon between the token's coming and going, repeats and retries included.
struct IconTime {
  Place at;
  Duration shortest{};  // what passes at least: the delays
  std::optional<Duration> longest;
  std::string unknown;                                         // why the longest is not known; empty: it is
  std::vector<std::pair<int, std::optional<Duration>>> codes;  // of one run, by its code
};

/// Of every icon at which time may pass, in the order of the program. The program has no errors.
std::vector<IconTime> icon_times(const Program& program, const Skills& skills, const SkillTimes& times,
                                 const Stop& stop = {});

}  // namespace pal::operations
