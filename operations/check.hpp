// What is wrong with an operation (docs/reference/operations.md lists the rules; `pal explain` each finding).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "operations/model.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::operations {

/// The templates of the skills that a cell has, by name.
using Skills = std::map<std::string, pan::Template>;

/// What a sensor of the cell shows.
struct Sensor {
  std::string unit;  // empty: a plain number
  std::string description;
};
/// The sensors that a cell has, by name.
using Sensors = std::map<std::string, Sensor>;

/// Asked again and again; true ends the checks. Empty: nothing does.
using Stop = std::function<bool()>;

/// Checks without skills: names, connections, reachability, sub-operations, loops. All checks take time that
/// grows with the size of the program. False: `stop` ended them, and not all was checked.
bool check_shape(const Program& program, Diagnostics& diagnostics, const Stop& stop = {});

/// Checks with the skills: that they exist, parameters, codes that no icon handles, ways that are never
/// taken. `locations`: those that are taught; nothing: unknown. The program has no errors of shape. False: as
/// of check_shape().
bool check_skills(const Program& program, const Skills& skills,
                  const std::optional<std::set<std::string>>& locations, Diagnostics& diagnostics,
                  const Stop& stop = {});

/// Checks one skill icon: that the skill exists, and its parameters.
void check_skill(const Icon& icon, const Skills& skills,
                 const std::optional<std::set<std::string>>& locations, Diagnostics& diagnostics);

/// Checks that the cell has the sensors which tests and waits read.
void check_sensors(const Program& program, const Sensors& sensors, Diagnostics& diagnostics);

/// The names of all skills that the operation and its sub-operations run.
std::set<std::string> skills_of(const Program& program);

}  // namespace pal::operations
