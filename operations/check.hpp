// What is wrong with an operation (docs/reference/operations.md lists the rules; `pal explain` each finding).
#pragma once

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

/// Checks without skills: names, connections, reachability, sub-operations, loops.
void check_shape(const Program& program, Diagnostics& diagnostics);

/// Checks with the skills: that they exist, parameters, codes that no icon handles, ways that are never
/// taken. `locations`: those that are taught; nothing: unknown. The program has no errors of shape.
void check_skills(const Program& program, const Skills& skills,
                  const std::optional<std::set<std::string>>& locations, Diagnostics& diagnostics);

/// Checks that the cell has the sensors which tests and waits read.
void check_sensors(const Program& program, const Sensors& sensors, Diagnostics& diagnostics);

/// The names of all skills that the operation and its sub-operations run.
std::set<std::string> skills_of(const Program& program);

}  // namespace pal::operations
