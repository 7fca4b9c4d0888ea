// The story of a run, scene by scene, in sentences.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "operations/executor.hpp"
#include "operations/model.hpp"

namespace pal::operations {

class Happened {
 public:
  /// Steps of a run of the program (read_log). Both outlive this object.
  Happened(const Program& program, const std::vector<Step>& steps);

  /// How many steps, from when to when.
  std::string summary() const;
  /// A sentence for each of the first steps, then how many more there were.
  std::vector<std::string> course() const;
  /// Of one icon: how often, when, for how long, with which codes.
  std::string at(Place place) const;
  /// How often the icon had a step, or a hierarchical one a step inside.
  std::size_t count(Place place) const;

 private:
  const Program& program_;
  const std::vector<Step>& steps_;
  std::map<Place, std::vector<std::size_t>> steps_at_;
};

}  // namespace pal::operations
