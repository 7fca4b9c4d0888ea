// From two sweeps: by how much one order of a skill presses harder, measured, and as the ages predict.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "programs/workcell/session/sweep.hpp"

namespace pal::workcell {

/// What the ages predict of the difference between two sweeps, and what was measured. Means over the runs
/// that both ended with completion 0.
struct Comparison {
  std::size_t pairs = 0;
  double speed = 0;               // mm/s
  double stiffness = 0;           // N/mm, between the mean resting forces
  double age_difference = 0;      // ms
  double predicted = 0;           // N: speed * age difference * stiffness
  double peak_difference = 0;     // N
  double resting_difference = 0;  // N
  std::size_t second_higher = 0;  // pairs in which the second skill's peak is the higher one

  /// The resting difference is within a quarter of the prediction. It cannot be nearer: the contact is not
  /// linear (a tenth between the forces of the two orders), and the ages differ from run to run. The peak has
  /// the arm's and the tool's inertia in it as well.
  bool agrees() const;
};

/// Pairs the runs by their order, and presses on the scene to find the stiffness. Nothing if no pair ended
/// with completion 0 in both.
std::optional<Comparison> compare(const std::vector<SweepRun>& first, const std::vector<SweepRun>& second,
                                  const sim::Scene& scene, double speed);

/// "overshoot past the threshold": counts, figures, histogram.
std::string describe(const std::string& skill, const std::vector<SweepRun>& runs, double low, double high);

std::string describe(const Comparison& comparison, const std::string& first, const std::string& second);

}  // namespace pal::workcell
