// What is wrong with an operation (docs/reference/operations.md lists the rules; `pal explain` each finding).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "operations/formula.hpp"
#include "operations/model.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::operations {

class Graph;

/// The templates of the skills that a cell has, by name.
using Skills = std::map<std::string, pan::Template>;

/// What a sensor of the cell shows, or a skill reports.
struct Sensor {
  std::string unit;  // empty: a plain number
  std::string description;
  std::optional<std::pair<double, double>> range{};  // that it can show; nothing: not known
};
/// By name: the sensors that a cell has, or the figures that it knows of a skill that has ended.
using Sensors = std::map<std::string, Sensor>;

/// Formulas of the longest time of a skill to a completion code, in s.
using DeclaredTimes = std::map<std::pair<std::string, int>, Formula>;

/// Why a skill refuses these values together, though each of them is one that it may have; nothing: it does
/// not. Called from several threads.
using RefusedTogether =
    std::function<std::optional<std::string>(const std::string& skill, const std::vector<Parameter>& given)>;

/// What is known of a cell in which an operation is to run.
struct Cell {
  std::optional<Skills> skills{};                    // nothing: not known
  std::optional<Sensors> sensors{};                  // likewise
  std::optional<Sensors> figures{};                  // … of skills, by figure
  std::optional<std::set<std::string>> locations{};  // those that are taught
  std::map<std::string, std::string> unable{};       // skills that it cannot run, and why
  DeclaredTimes longest{};                           // nobody has proved them; the cell watches them
  RefusedTogether refused_together{};                // empty: not known
};

/// Asked again and again; true ends the checks. Empty: nothing does.
using Stop = std::function<bool()>;

/// Checks without skills: names, connections, reachability, sub-operations, loops. All checks take time that
/// grows with the size of the program. False: `stop` ended them, and not all was checked.
bool check_shape(const Program& program, Diagnostics& diagnostics, const Stop& stop = {});

/// Checks against what is known of the cell: that it has the skills and can run them; parameters; locations;
/// sensors; figures of skills; with skills, codes that no icon handles and ways that are never taken. The
/// program has no errors of shape. False: as of check_shape().
bool check_cell(const Program& program, const Cell& cell, Diagnostics& diagnostics, const Stop& stop = {});

/// The same of the parameters of one icon, a skill or a hierarchical one, in place of those that it has.
void check_parameters(const Graph& graph, Place at, const Icon& changed, const Cell& cell,
                      Diagnostics& diagnostics);

/// The names of all skills that the operation and its sub-operations run.
std::set<std::string> skills_of(const Program& program);

}  // namespace pal::operations
