// What skill icons ask of a cell's skills and locations.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/graph.hpp"
#include "operations/suggestion.hpp"

namespace pal::operations {

/// Checks icons one by one. The program has no errors of shape.
class SkillChecks {
 public:
  /// All outlive the checks; the cell knows its skills.
  SkillChecks(const Graph& graph, const Cell& cell, Diagnostics& diagnostics);

  /// `icon`, a skill or a hierarchical icon, stands or is to stand at this place.
  void check(Place at, const Icon& icon);
  /// The defaults of an operation's arguments.
  void check_arguments(std::size_t operation);

 private:
  void note_locations(Place at);
  bool names_location(Place at, const Icon& icon, const Parameter& given) const;
  void check_together(const Icon& icon);
  bool check_given(const pan::Template& skill, const Parameter& given, const Operation& operation);
  /// What an operator may set is there, and within its range.
  void check_operator(const Icon& icon, const std::string& whose,
                      const std::vector<pan::Parameter>& parameters);
  void check_location(const Icon& icon, const pan::Parameter& parameter);
  void check_taught(const std::string& location, SourceSpan where);

  const Graph& graph_;
  const Cell& cell_;
  Diagnostics& diagnostics_;
  Suggestions suggestions_;
  std::vector<std::string> skill_names_, location_names_;
  /// By operation: those that name a location inside it.
  std::vector<std::set<std::string>> location_arguments_;
};

}  // namespace pal::operations
