// A skill tried aside: in a simulator of its own, without the cell.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "operations/executor.hpp"

namespace pal::server {

struct Trial {
  struct Skill {
    std::string skill;
    std::vector<operations::Parameter> parameters;
  };
  /// Degrees, as locations have them; not given: where the cell began.
  std::optional<std::array<double, 6>> joints;
  std::vector<Skill> before;  // run first, so that the skill begins where it would
  Skill tried;
  std::uint64_t seed = 1;  // of everything that the simulator draws
};

struct TrialResult {
  operations::SkillResult result;
  Duration begin{}, end{};  // of the simulator
};

class Trials {
 public:
  virtual ~Trials() = default;
  /// From any thread, one call at a time. Ends soon when `stop` says so; the result is that of a stopped
  /// skill then. A skill before that does not end normally ends the trial with its result. Locations are
  /// those that the cell has been taught.
  virtual TrialResult run(const Trial& trial, const std::function<bool()>& stop) = 0;
};

}  // namespace pal::server
