// How long the icons of an operation take, as far as it is proved or declared.
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

/// By skill and completion code.
using ProvedTimes = std::map<std::pair<std::string, int>, Duration>;

/// The longest times of skills. What is proved goes before what is declared.
struct SkillTimes {
  ProvedTimes proved{};
  DeclaredTimes declared{};
};

/// The declared longest time of a skill with these parameters; those that are not given have their defaults.
/// An argument of `operation`, if there is one, may have all values of its range, and what is known only when
/// it runs all those of the skill's. Nothing: none is declared, or it has no bound.
std::optional<Duration> declared_longest(const pan::Template& skill, int code,
                                         const std::vector<Parameter>& parameters, const Operation* operation,
                                         const DeclaredTimes& times);

/// Of one run; without a time, why none is known: "touch", "the sensor force-z".
struct Longest {
  std::optional<Duration> time;
  std::string unknown;
  bool declared = false;  // not proved
};
/// Of an icon of `operation`. Of a sensor and of a person nothing is proved.
Longest longest_of(const Icon& icon, const Operation& operation, int code, const Skills& skills,
                   const SkillTimes& times);
/// Nothing: it is too long to be told.
std::optional<Duration> multiplied(Duration time, double by);

/// All runs of an icon between the token's coming and going, repeats and retries included.
struct IconTime {
  Place at;
  Duration shortest{};  // what passes at least: the delays
  std::optional<Duration> longest;
  std::string unknown;                                         // why the longest is not known; empty: it is
  std::vector<std::pair<int, std::optional<Duration>>> codes;  // of one run, by its code
  bool declared = false;                                       // some of these times are declared, not proved
};

/// Of every icon at which time may pass, in the order of the program. The program has no errors.
std::vector<IconTime> icon_times(const Program& program, const Skills& skills, const SkillTimes& times,
                                 const Stop& stop = {});

}  // namespace pal::operations
